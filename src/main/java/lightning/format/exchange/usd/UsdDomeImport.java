package lightning.format.exchange.usd;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import lightning.base.file.UnusableFileException;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.gltf.JsonValue;
import lightning.format.image.ImageFile;
import lightning.format.image.ImageSource;
import lightning.format.jen.asset.EnvironmentReader;
import lightning.format.jen.asset.FileKind;
import lightning.format.mesh.MeshException;
import lightning.format.usd.UsdStage;
import lightning.render.image.Film;
import lightning.scene.Dome;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.value.ColorTemperature;
import lightning.scene.value.DomeRotation;
import lightning.scene.value.SceneLimits;

/** Converter from a dome light to an environment: an image in Radiance's format, which is written where the dome has another or none. */
record UsdDomeImport(SceneAssembler assembler, Transform upright, boolean hasZUp) {
    /** Largest number of pixels of an environment. */
    private static final int MAX_PIXELS = 8 << 20;
    private static final int PLAIN_WIDTH = 16;
    /** Smaller angles are 0, degrees. */
    private static final double MIN_ANGLE = 1e-4;

    /** Sets the environment, or adds a dome after the first, and the comment that brings it back. */
    void add(JsonValue in) throws IOException, MeshException {
        double exposure = UsdNumbers.tidy(in.get("exposure").number(0));
        double intensity = UsdNumbers.tidy(in.get("intensity").number(1));
        double stops = Math.pow(2, exposure);
        double wanted = in.get("hidden").bool(false) ? 0 : intensity * stops;
        double strength = Math.clamp(wanted, 0, SceneLimits.MAX_GROUP_INTENSITY);
        double[] c = in.get("color").numbers(1, 1, 1);
        Rgb tint =
                in.get("temperature").isPresent() ? UsdBlackbody.tint(in.get("temperature").number(ColorTemperature.NEUTRAL)) : Rgb.WHITE;
        Rgb color = new Rgb(Math.max(c[0], 0), Math.max(c[1], 0), Math.max(c[2], 0)).times(tint);
        Rgb factor = color.times(strength > 0 ? wanted / strength : 1);
        JsonValue texture = in.get("texture");
        String format = in.get("format").text().orElse("automatic");
        assembler.notes.add("dome lights of format " + format, format.equals("automatic") || format.equals("latlong") ? 0 : 1);
        assembler.notes.add("diffuse and specular factors of dome lights",
                in.get("diffuse").number(1) == 1 && in.get("specular").number(1) == 1 ? 0 : 1);
        Optional<Path> place = texture.isPresent() ? UsdStage.place(texture) : Optional.empty();
        assembler.notes.add("dome lights whose image is missing or unreadable", texture.isPresent() && place.isEmpty() ? 1 : 0);
        Environment environment = place.isPresent() ? image(place.get(), texture, factor) : plain(factor);
        DomeRotation rotation = rotation(in);
        // The intensity of the dome for one of the environment; its color and exposure stay as they are.
        double ratio = strength > 0 ? intensity / strength : 1 / stops;
        boolean isFirst = !assembler.world.hasEnvironment();
        String name = isFirst ? Dome.OWN : assembler.names.unique(in.get("name").text().orElse(""), "dome");
        Dome dome = Dome.of(name).withImage(Optional.of(environment)).withRotation(rotation).withIntensity(strength);
        if (isFirst) {
            assembler.world = assembler.world.withOwn(_ -> dome);
        } else {
            assembler.addDome(dome);
        }
        UsdPaths.addDome(assembler, in, ratio, rotation, strength, environment.file(), name);
    }

    private Environment image(Path place, JsonValue texture, Rgb factor) throws IOException, MeshException {
        String name = texture.get("name").text().orElse("dome");
        if (FileKind.ENVIRONMENT.isNamed(name) && factor.equals(Rgb.WHITE) && assembler.canAdd(place)) {
            try {
                EnvironmentMap map =
                        EnvironmentReader.read(name, place, assembler.world.images().stream().mapToLong(EnvironmentMap::bytes).sum(),
                                _ -> assembler.notes.add("dome lights with values that are not finite"));
                return new Environment(assembler.addFile(place, name), map);
            } catch (UnusableFileException e) {
                return unreadable(factor);
            }
        }
        Film film;
        try {
            film = ImageFile.read(name, place, ImageFile.PICTURES, ImageSource::film);
        } catch (UnusableFileException e) {
            return unreadable(factor);
        }
        int size = 1;
        while ((long) (film.width() / size) * (film.height() / size) > MAX_PIXELS) {
            size++;
        }
        assembler.notes.add("images of dome lights of more than 8 million pixels, reduced", size == 1 ? 0 : 1);
        assembler.notes.add("images of dome lights, written as Radiance HDR");
        return written(name.replaceFirst("\\.[^.]*$", "") + ".dome.hdr", map(film, size, factor));
    }

    /** Notes that an image cannot be read, and returns the plain environment instead. */
    private Environment unreadable(Rgb factor) throws IOException {
        assembler.notes.add("dome lights whose image is missing or unreadable");
        return plain(factor);
    }

    /** Returns the map of an image, times a color; {@code size} × {@code size} pixels become one. */
    private static EnvironmentMap map(Film film, int size, Rgb factor) {
        int width = film.width() / size;
        int height = film.height() / size;
        float[] rgb = new float[3 * width * height];
        for (int y = 0; y < height * size; y++) {
            for (int x = 0; x < width * size; x++) {
                int i = 3 * (y / size * width + x / size);
                rgb[i] += (float) (film.red(x, y) * factor.r() / (size * size));
                rgb[i + 1] += (float) (film.green(x, y) * factor.g() / (size * size));
                rgb[i + 2] += (float) (film.blue(x, y) * factor.b() / (size * size));
            }
        }
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = rgb[i] >= 0 ? Math.min(rgb[i], (float) SceneLimits.MAX_EMISSION) : 0;
        }
        return new EnvironmentMap(width, height, rgb);
    }

    private Environment plain(Rgb color) throws IOException {
        float[] rgb = new float[3 * PLAIN_WIDTH * PLAIN_WIDTH / 2];
        for (int i = 0; i < rgb.length; i += 3) {
            rgb[i] = (float) Math.min(color.r(), SceneLimits.MAX_EMISSION);
            rgb[i + 1] = (float) Math.min(color.g(), SceneLimits.MAX_EMISSION);
            rgb[i + 2] = (float) Math.min(color.b(), SceneLimits.MAX_EMISSION);
        }
        return written("dome.hdr", new EnvironmentMap(PLAIN_WIDTH, PLAIN_WIDTH / 2, rgb));
    }

    /** Returns a Radiance HDR file with the pixels of a map; not its sun. */
    static byte[] hdr(EnvironmentMap map) throws IOException {
        return ImageFile.toHdr(Film.ofScanlines(map.width(), map.height(), map.values()));
    }

    private Environment written(String name, EnvironmentMap map) throws IOException {
        return new Environment(assembler.addFile(name, hdr(map)), map);
    }

    /**
     * Returns the rotation of the image. A dome's image has +z in its center and x on its left, an environment −z and x on its right: half a turn
     * apart.
     */
    private DomeRotation rotation(JsonValue in) throws MeshException {
        Transform m = upright.times(UsdStage.transform(in.get("matrix")));
        String pole = in.get("pole").text().orElse("Y");
        if (pole.equals("Z") || pole.equals("scene") && hasZUp) {
            m = m.times(Transform.rotation(new Vec3(90, 0, 0)));
        }
        DomeRotation turned = DomeRotation.of(m.times(Transform.rotation(new Vec3(0, 180, 0))));
        assembler.notes.add("mirrored dome lights, imported without the mirror", isMirrored(m) ? 1 : 0);
        return DomeRotation.of(tidy(turned.rotation()), tidy(turned.tilt()), tidy(turned.roll()));
    }

    private static boolean isMirrored(Transform m) {
        return m.transformVector(new Vec3(1, 0, 0)).cross(m.transformVector(Vec3.Y)).dot(m.transformVector(new Vec3(0, 0, 1))) < 0;
    }

    /** Returns an angle in degrees without what matrices of single precision add to it. */
    private static double tidy(double degrees) {
        return Math.abs(degrees) < MIN_ANGLE ? 0 : UsdNumbers.rounded(degrees);
    }
}
