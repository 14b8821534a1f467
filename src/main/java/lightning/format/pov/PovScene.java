package lightning.format.pov;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.base.file.AtomicFile;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.format.image.ImageFile;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Camera;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.node.Solid;
import lightning.scene.value.DomeRotation;

/**
 * Scene in POV-Ray's language.
 *
 * @param text         content of the file
 * @param losses       features that POV-Ray does not support exactly, one sentence each, with names of the scene
 * @param images       images of materials by the names of their files, to which the text refers
 * @param bumpMaps     bump maps by the names of their files
 * @param environments images of environments by the names of their files
 */
public record PovScene(String text, List<String> losses, Map<String, Texture> images, Map<String, Texture> bumpMaps,
        Map<String, EnvironmentMap> environments) {
    /** Maximum number of cutouts that a ray passes; POV-Ray counts them like reflections. */
    private static final int CUTOUT_LEVELS = 20;

    public PovScene {
        losses = List.copyOf(losses);
    }

    /**
     * Converts a scene.
     *
     * @param name prefix of the names of its image files
     */
    public static PovScene of(Scene scene, String name) {
        List<String> warnings = new ArrayList<>();
        Map<String, Texture> images = new LinkedHashMap<>();
        Map<String, Texture> bumpMaps = new LinkedHashMap<>();
        Map<String, EnvironmentMap> environments = new LinkedHashMap<>();
        var body = new StringBuilder();
        body.append("global_settings {\n  assumed_gamma 1.0\n  max_trace_level ")
                .append(scene.picture().depth() + 1 + (hasCutouts(scene) ? CUTOUT_LEVELS : 0))
                .append("\n  adc_bailout 0\n  ambient_light rgb ").append(scene.world().ambience()).append("\n}\n");
        body.append("background { ").append(PovFormat.rgb(scene.world().background())).append(" }\n");
        scene.world().environment().ifPresent(p -> {
            warnings.add("the environment is exported as sample lights and as an image of the background");
            String file = fileName(name + "-environment", p.file()) + ".hdr";
            environments.put(file, p.map());
            // POV-Ray's image starts at the x axis and runs toward z; ours starts a quarter earlier, with its middle at −z.
            body.append("sky_sphere {\n  pigment { image_map { hdr \"").append(file)
                    .append("\" map_type 1 interpolate 2 } }\n  ").append(rotation(scene.world().own().rotation()))
                    .append("\n  emission rgb ")
                    .append(scene.world().own().intensity())
                    .append("\n}\n");
        });
        if (scene.world().named().stream().anyMatch(d -> d.on() && d.image().isPresent())) {
            warnings.add("domes are exported as sample lights, their images are left out");
        }
        if (scene.picture().indirect().isPresent()) {
            warnings.add("indirect light is left out");
        }
        body.append(camera(scene));
        var meshes = new PovMeshWriter(scene, warnings);
        body.append(meshes.declarations());
        var materials = new PovMaterialWriter(warnings);
        for (PlacedShape shape : scene.placedShapes()) {
            String image = shape.material().texture().map(t -> addImage(images, t, name)).orElse("");
            String mask = shape.material().cutout().map().map(t -> addImage(images, t, name + "-cutout")).orElse("");
            String bumps = shape.material().bumpMapping().bump().filter(_ -> shape.material().bumpMapping().hasBumpMap())
                    .map(t -> addImage(bumpMaps, t, name + "-bump")).orElse("");
            body.append("// ").append(shape.shape().name()).append('\n').append(solid(shape.shape().solid(), meshes)).append("\n  ")
                    .append(materials.text(shape.material(), shape.shape().solid(), image, mask, bumps)).append("\n  ")
                    .append(PovFormat.matrix(shape.toWorld())).append("\n}\n");
        }
        var lights = new PovLightWriter(BoundingSphere.of(scene), warnings);
        scene.lightsForOtherPrograms().forEach(light -> body.append(lights.text(scene, light)));
        return new PovScene(header(scene, warnings) + body, warnings, images, bumpMaps, environments);
    }

    private static String rotation(DomeRotation dome) {
        return dome.isUpright() ? "rotate <0, " + (dome.rotation() - 90) + ", 0>"
                : "rotate <0, -90, 0>\n  " + PovFormat.matrix(dome.toWorld());
    }

    private static boolean hasCutouts(Scene scene) {
        return scene.materials().stream().anyMatch(m -> m.cutout().isActive());
    }

    private static String header(Scene scene, List<String> warnings) {
        var header = new StringBuilder("// For POV-Ray 3.7. Run in this folder: povray +Ithis.pov +W" + scene.picture().width()
                + " +H" + scene.picture().height() + " -A -D\n");
        warnings.forEach(warning -> header.append("// Not exported exactly: ").append(warning).append('\n'));
        return header.append("#version 3.7;\n").toString();
    }

    private static String camera(Scene scene) {
        Camera camera = scene.camera();
        Vec3 forward = camera.to().minus(camera.from()).normalized();
        Vec3 right = forward.cross(camera.up().normalized()).normalized();
        Vec3 up = right.cross(forward);
        double half = camera.fov() / 2;
        double distance = 0.5 * Transform.cosDegrees(half) / Transform.sinDegrees(half);
        double aspect = (double) scene.picture().width() / scene.picture().height();
        // A direction that is not perpendicular to the image plane shifts the picture.
        Vec3 direction = forward.times(distance).plus(right.times(aspect * camera.shift().x())).plus(up.times(camera.shift().y()));
        return "camera {\n  perspective\n  location " + PovFormat.vector(camera.from()) + "\n  direction "
                + PovFormat.vector(direction) + "\n  right " + PovFormat.vector(right.times(aspect)) + "\n  up "
                + PovFormat.vector(up) + "\n}\n";
    }

    /** Returns a solid, left open for texture and transform. */
    private static String solid(Solid solid, PovMeshWriter meshes) {
        return switch (solid) {
            case Solid.Canonical c -> c.toPovRay();
            case Solid.TriangleMesh t -> meshes.text(t);
        };
    }

    private static String addImage(Map<String, Texture> images, TextureMap map, String name) {
        String file = fileName(name, map.file()) + ".png";
        images.put(file, map.image());
        return file;
    }

    /** Returns the name of an image's copy, without its extension. */
    private static String fileName(String prefix, String imageFile) {
        return prefix.replaceAll("[\"\\\\\\p{C}]", "_") + "-" + imageFile.replaceAll("[^\\p{Alnum}_-]", "_");
    }

    /**
     * Writes the scene, and its textures and environment image next to it.
     *
     * @throws IOException if a file cannot be written
     */
    public void write(Path file) throws IOException {
        for (var image : images.entrySet()) {
            Texture texture = image.getValue();
            write(file.resolveSibling(image.getKey()), texture.width(), texture.height(), texture.values());
        }
        for (var image : bumpMaps.entrySet()) {
            // Bump slopes are differences of neighbors, which 8 bits would quantize visibly.
            ImageFile.write(file.resolveSibling(image.getKey()), gray(image.getValue()), new ViewTransform(0, DisplayCurve.LINEAR), 16);
        }
        for (var environment : environments.entrySet()) {
            EnvironmentMap map = environment.getValue();
            write(file.resolveSibling(environment.getKey()), map.width(), map.height(), map.values());
        }
        AtomicFile.write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }

    private static void write(Path file, int width, int height, float[] rgb) throws IOException {
        ImageFile.write(file, Film.ofScanlines(width, height, rgb), ViewTransform.DEFAULT);
    }

    /** Returns the luminance as gray, because POV-Ray weights channels differently. */
    private static Film gray(Texture texture) {
        float[] rgb = new float[3 * texture.width() * texture.height()];
        for (int i = 0; i < rgb.length; i++) {
            int x = i / 3 % texture.width();
            int y = i / 3 / texture.width();
            rgb[i] = (float) texture.luminance(x, y, x, y, 0, 0);
        }
        return Film.ofScanlines(texture.width(), texture.height(), rgb);
    }
}
