package lightning.format.exchange.usd;

import java.io.IOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.text.RefusalException;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.gltf.JsonValue;
import lightning.format.ies.IesReader;
import lightning.format.jen.asset.TextureFile;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;
import lightning.format.usd.UsdStage;
import lightning.scene.asset.IesProfile;
import lightning.scene.asset.LightTexture;
import lightning.scene.asset.Texture;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Beam;
import lightning.scene.light.Emission;
import lightning.scene.light.Falloff;
import lightning.scene.light.Influence;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.ColorTemperature;
import lightning.scene.value.Photometry;
import lightning.scene.value.SceneLimits;

/**
 * Converter from UsdLux, whose intensity is the luminance of a light's surface in nits, or that times its area if normalized.
 * {@link UsdLightExport} inverts it.
 *
 * @param upright rotation of the stage to a scene with y up
 * @param meters meters per scene unit
 * @param notes receives what cannot be imported
 * @param softCones profiles of the scene's soft cones
 */
record UsdLightImport(SceneAssembler assembler, Transform upright, double meters, ConversionNotes notes, SoftCones softCones) {
    private static final MathContext DIGITS = new MathContext(12);

    /** Returns a light without links; empty if it cannot be imported. */
    Optional<Light> convert(String name, JsonValue in) throws IOException, MeshException {
        try {
            String type = in.get("type").text().orElse("");
            Light light = Light.of(name, LightType.POINT).withFalloff(Falloff.INVERSE_SQUARE);
            Optional<Light> shaped = switch (type) {
                case "DistantLight" -> Optional.of(distant(light, in));
                case "SphereLight" -> Optional.of(sphere(light, in));
                case "DiskLight" -> Optional.of(disk(light, in));
                case "RectLight" -> Optional.of(rect(light, in));
                case "CylinderLight" -> Optional.of(cylinder(light, in));
                case "MeshLight" -> Optional.of(mesh(light, in));
                default -> Optional.empty();
            };
            notes.add("lights of type " + type, shaped.isEmpty() ? 1 : 0);
            notes.add("textures of lights",
                    shaped.isPresent() && shaped.get().texture().isEmpty() && in.get("texture").isPresent() ? 1 : 0);
            return shaped.isEmpty() ? shaped : Optional.of(emission(shaped.get(), in));
        } catch (RefusalException | ArithmeticException e) {
            notes.add("lights that cannot be placed");
            return Optional.empty();
        }
    }

    private Light distant(Light light, JsonValue in) throws MeshException {
        notes.add("cones and profiles of distant lights", isShapedFlat(in.get("shaping")) ? 1 : 0);
        double spread = Math.clamp(UsdNumbers.tidy(in.get("angle").number(0)) / 2, 0, SceneLimits.MAX_SPREAD);
        return placed(light, in).withType(LightType.DIRECTIONAL).withPosition(Vec3.ZERO).withFalloff(Falloff.CUSTOM)
                .withArea(AreaShape.DEFAULT.withSpread(spread))
                .withEmission(Emission.DEFAULT.withUnit(isNormalized(in) || spread == 0 ? IntensityUnit.LUX : IntensityUnit.NIT));
    }

    private Light sphere(Light light, JsonValue in) throws IOException, MeshException {
        Vec3 scale = scale(in);
        noteScale(scale.x(), LightScales.isRound(scale.x(), scale.y()) ? scale.z() : scale.y());
        double radius = UsdNumbers.tidy(in.get("radius").number(0)) * LightScales.sphere(scale);
        boolean isPoint = in.get("treatAsPoint").bool(false);
        Light ball = placed(light, in).withArea(AreaShape.DEFAULT.withRadius(isPoint ? 0 : size(radius)));
        // A ball's surface is four times the disc as which it is seen.
        ball = isNormalized(in) ? candela(ball, meters * meters / 4)
                : isPoint ? candela(ball, Math.PI * radius * radius * meters * meters) : nit(ball);
        JsonValue shaping = in.get("shaping");
        return isShaped(shaping) ? cone(ball, shaping) : ball.withDirection(light.direction());
    }

    private Light disk(Light light, JsonValue in) throws IOException, MeshException {
        Vec3 scale = scale(in);
        noteScale(scale.x(), scale.y());
        Light disc = placed(light, in).withType(LightType.DISC)
                .withArea(AreaShape.DEFAULT.withRadius(size(UsdNumbers.tidy(in.get("radius").number(0)) * LightScales.disk(scale))));
        disc = isNormalized(in) ? candela(disc, meters * meters) : nit(disc);
        return isShapedFlat(in.get("shaping")) ? beam(disc, in.get("shaping")) : disc;
    }

    private Light rect(Light light, JsonValue in) throws IOException, MeshException {
        Vec3 scale = scale(in);
        Vec3 up = world(in).transformVector(Vec3.Y).normalized();
        Light rect = placed(light, in).withType(LightType.RECT).withArea(AreaShape.DEFAULT.withUp(UsdNumbers.rounded(up))
                .withWidth(size(UsdNumbers.tidy(in.get("width").number(0)) * scale.x()))
                .withHeight(size(UsdNumbers.tidy(in.get("height").number(0)) * scale.y())));
        rect = isShapedFlat(in.get("shaping")) ? beam(rect, in.get("shaping")) : rect;
        return (isNormalized(in) ? candela(rect, meters * meters) : nit(rect)).withTexture(texture(in.get("texture")));
    }

    /** Returns the image on a rectangle; empty if there is none, or it cannot be used. */
    private Optional<LightTexture> texture(JsonValue file) throws IOException, MeshException {
        Optional<Path> place = file.isPresent() ? UsdStage.place(file) : Optional.empty();
        if (place.isEmpty()) {
            return Optional.empty();
        }
        try {
            String name = file.get("name").text().orElse("texture");
            // Read before it is copied: a hostile stage may name any file of this machine.
            Texture image = TextureFile.read(name, place.get());
            return Optional.of(new LightTexture(assembler.addFile(place.get(), name), image));
        } catch (IOException e) {
            return Optional.empty();
        }
    }

    /** Returns the light of a mesh, without the name of its shape. */
    private Light mesh(Light light, JsonValue in) throws MeshException {
        notes.add("cones and profiles of mesh lights", isShaped(in.get("shaping")) ? 1 : 0);
        Light surface = light.withType(LightType.OBJECT);
        return isNormalized(in) ? candela(surface, meters * meters) : nit(surface);
    }

    private Light cylinder(Light light, JsonValue in) throws MeshException {
        Vec3 scale = scale(in);
        double length = size(UsdNumbers.tidy(in.get("length").number(0)) * scale.x());
        double radius = size(UsdNumbers.tidy(in.get("radius").number(0)) * LightScales.tube(scale));
        noteScale(scale.y(), scale.z());
        notes.add("cones and profiles of cylinder lights", isShaped(in.get("shaping")) ? 1 : 0);
        boolean isLine = in.get("treatAsLine").bool(false);
        Light tube = placed(light, in).withType(LightType.TUBE)
                .withDirection(UsdNumbers.rounded(world(in).transformVector(new Vec3(1, 0, 0)).normalized()))
                .withArea(AreaShape.DEFAULT.withRadius(isLine ? 0 : radius).withHeight(length));
        // Its side is π times the rectangle as which it is seen.
        return isNormalized(in) ? candela(tube, meters * meters / Math.PI)
                : isLine ? candela(tube, 2 * radius * length * meters * meters) : nit(tube);
    }

    /** Returns a rectangle or disc with its cone, focus and profile. */
    private Light beam(Light light, JsonValue shaping) throws IOException, MeshException {
        notes.add("angle scales of IES profiles", shaping.get("angleScale").number(0) == 0 ? 0 : 1);
        double angle = Math.clamp(UsdNumbers.tidy(shaping.get("angle").number(90)), 0, SceneLimits.MAX_ANGLE);
        double softness = softness(shaping);
        // The soft edge of a cone wider than the half space, where it begins before 90 degrees, is moved to its end.
        notes.add("soft cones wider than 90 degrees of lights that shine to one side, narrowed to 90",
                angle > Beam.OPEN_ANGLE && (1 - softness) * angle < Beam.OPEN_ANGLE ? 1 : 0);
        double cone = Math.min(angle, Beam.OPEN_ANGLE);
        double start = Math.min((1 - softness) * angle, cone);
        return light.withBeam(Beam.OPEN.withCone(cone).withSoftness(angle <= Beam.OPEN_ANGLE ? softness : 1 - start / cone))
                .withDropoff(focus(shaping)).withProfile(profile(shaping.get("profile")));
    }

    private static double focus(JsonValue shaping) throws MeshException {
        return SceneAssembler.clamp(UsdNumbers.tidy(shaping.get("focus").number(0)), SceneLimits.MAX_DROPOFF);
    }

    private static double softness(JsonValue shaping) throws MeshException {
        return SceneAssembler.clamp(UsdNumbers.tidy(shaping.get("softness").number(0)), 1);
    }

    private Light cone(Light light, JsonValue shaping) throws IOException, MeshException {
        double angle = Math.clamp(UsdNumbers.tidy(shaping.get("angle").number(90)), 0, SceneLimits.MAX_ANGLE);
        double softness = softness(shaping);
        Light spot = light.withType(LightType.SPOT).withAngle(angle).withDropoff(focus(shaping));
        notes.add("angle scales of IES profiles", shaping.get("angleScale").number(0) == 0 ? 0 : 1);
        boolean isSoft = softness > 0 && angle > 0;
        Optional<IesProfile> soft = isSoft && !shaping.get("profile").isPresent() && !shaping.get("moves").bool(false)
                ? softCones.profile(angle, softness) : Optional.empty();
        if (soft.isPresent()) {
            return spot.withProfile(soft);
        }
        notes.add("soft edges of cones (shaping:cone:softness) with a profile or animation, imported as hard at half intensity",
                isSoft ? 1 : 0);
        return spot.withAngle(UsdNumbers.rounded(angle * (1 - softness / 2))).withProfile(profile(shaping.get("profile")));
    }

    private Optional<IesProfile> profile(JsonValue file) throws IOException, MeshException {
        if (!file.isPresent()) {
            return Optional.empty();
        }
        Optional<Path> place = UsdStage.place(file);
        if (place.isEmpty()) {
            notes.add("IES profiles that are missing");
            return Optional.empty();
        }
        try {
            // Read before it is copied: a hostile stage may name any file of this machine.
            Photometry photometry = IesReader.read(place.get());
            String name = file.get("name").text().orElse("profile");
            return Optional.of(new IesProfile(
                    assembler.addFile(place.get(), name.toLowerCase(Locale.ROOT).endsWith(".ies") ? name : name + ".ies"), photometry));
        } catch (IOException | MeshException e) {
            notes.add("IES profiles that are damaged");
            return Optional.empty();
        }
    }

    private Light placed(Light light, JsonValue in) throws MeshException {
        Transform m = world(in);
        return light.withPosition(UsdNumbers.rounded(m.transformPoint(Vec3.ZERO)))
                .withDirection(UsdNumbers.rounded(m.transformVector(new Vec3(0, 0, -1)).normalized()));
    }

    private Light emission(Light light, JsonValue in) throws MeshException {
        double[] color = in.get("color").numbers(1, 1, 1);
        double temperature = in.get("temperature").number(ColorTemperature.NEUTRAL);
        double allowed = Math.clamp(temperature, ColorTemperature.MIN, ColorTemperature.MAX);
        double exposure = UsdNumbers.tidy(in.get("exposure").number(0));
        double stops = Math.clamp(exposure, -Emission.MAX_EXPOSURE, Emission.MAX_EXPOSURE);
        double intensity = UsdNumbers.tidy(in.get("intensity").number(1)) * light.intensity() * Math.pow(2, exposure - stops);
        notes.add("negative intensities of lights", intensity < 0 ? 1 : 0);
        Rgb correction = in.get("temperature").isPresent() ? UsdBlackbody.correction(temperature, allowed) : Rgb.WHITE;
        return light.withColor(color(color, correction))
                .withIntensity(SceneAssembler.clamp(shortened(intensity), SceneLimits.MAX_INTENSITY))
                .withEmission(light.emission().withExposure(stops).withTemperature(UsdNumbers.tidy(allowed)))
                .withOn(!in.get("hidden").bool(false))
                .withInfluence(Influence.DEFAULT.withCastsShadows(in.get("shadows").bool(true))
                        .withDiffuse(SceneAssembler.clamp(UsdNumbers.tidy(in.get("diffuse").number(1)), SceneLimits.MAX_GAIN))
                        .withSpecular(SceneAssembler.clamp(UsdNumbers.tidy(in.get("specular").number(1)), SceneLimits.MAX_GAIN)));
    }

    private Rgb color(double[] color, Rgb correction) {
        return new Rgb(channel(color[0], correction.r()), channel(color[1], correction.g()), channel(color[2], correction.b()));
    }

    private double channel(double v, double correction) {
        double wanted = UsdNumbers.tidy(v);
        double corrected = correction == 1 ? wanted : shortened(wanted * correction);
        double allowed = SceneAssembler.clamp(corrected, SceneLimits.MAX_LIGHT_COLOR);
        notes.add("channels of lights' colors beyond 0 to 1000", allowed == corrected ? 0 : 1);
        return allowed;
    }

    /** Returns a light whose intensity in candelas is the factor times that of the stage. */
    private static Light candela(Light light, double factor) {
        return light.withEmission(Emission.DEFAULT.withUnit(IntensityUnit.CANDELA)).withIntensity(factor);
    }

    private static Light nit(Light light) {
        return light.withEmission(Emission.DEFAULT.withUnit(IntensityUnit.NIT)).withIntensity(1);
    }

    private static boolean isNormalized(JsonValue in) throws MeshException {
        return in.get("normalize").bool(false);
    }

    private static boolean isShaped(JsonValue shaping) throws MeshException {
        return shaping.isPresent()
                && (shaping.get("angle").number(90) < 180 || shaping.get("focus").number(0) > 0 || shaping.get("profile").isPresent());
    }

    /** Returns whether a light is shaped that shines to one side only, where a hard cone of 90 degrees has no effect. */
    private static boolean isShapedFlat(JsonValue shaping) throws MeshException {
        return isShaped(shaping) && (shaping.get("angle").number(90) < 90 || shaping.get("softness").number(0) > 0
                || shaping.get("focus").number(0) > 0 || shaping.get("profile").isPresent());
    }

    private Transform world(JsonValue in) throws MeshException {
        return upright.times(UsdStage.transform(in.get("matrix")));
    }

    private Vec3 scale(JsonValue in) throws MeshException {
        return LightScales.of(world(in));
    }

    private void noteScale(double a, double b) {
        notes.add("round lights scaled to ellipses, imported as round ones of the same area", LightScales.isRound(a, b) ? 0 : 1);
    }

    private static double size(double v) {
        return UsdNumbers.rounded(SceneAssembler.clamp(v, SceneLimits.MAX_EXTENT));
    }

    /** Rounds a product of floats to more digits than they have. */
    private static double shortened(double v) {
        return Double.isFinite(v) ? new BigDecimal(v).round(DIGITS).doubleValue() : v;
    }
}
