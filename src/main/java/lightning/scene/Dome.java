package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.text.Messages;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentLight;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.light.AreaShape;
import lightning.scene.light.EnvironmentLights;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.DomeRotation;
import lightning.scene.value.SceneLimits;

/**
 * Environment of a scene, whose radiance is added to that of the others: a dome, or the world's own.
 *
 * @param name       of a dome: unique among domes, lights, light groups, shapes and groups; of its lights, before a number
 * @param image      environment map; a dome without one has no effect
 * @param rotation   rotation of the image
 * @param intensity  factor of its image and light
 * @param gain       factor of its light alone; its image stays
 * @param lightCount maximum number of directional lights that represent its small bright parts
 * @param softness   spread of each light over its part, 0 … 1
 * @param on         false if it is neither visible nor lights anything
 * @param solo       true if its light is soloed: if it is not dark, all lights and environments that are not solo are dark
 */
@RecordBuilder
public record Dome(String name, Optional<Environment> image, DomeRotation rotation, double intensity, double gain, int lightCount,
        double softness, boolean on, boolean solo) implements DomeBuilder.With {
    public static final SceneAttribute<Dome, Optional<Environment>> ENVIRONMENT =
            like(World.ENVIRONMENT, "image", Dome::image, Dome::withImage);
    public static final SceneAttribute<Dome, Double> ROTATION = like(World.ROTATION, "rotation", dome -> dome.rotation.rotation(),
            (dome, v) -> dome.withRotation(dome.rotation.withRotation(v)));
    public static final SceneAttribute<Dome, Double> TILT = like(World.TILT, "tilt", dome -> dome.rotation.tilt(),
            (dome, v) -> dome.withRotation(dome.rotation.withTilt(v)));
    public static final SceneAttribute<Dome, Double> ROLL = like(World.ROLL, "roll", dome -> dome.rotation.roll(),
            (dome, v) -> dome.withRotation(dome.rotation.withRoll(v)));
    public static final SceneAttribute<Dome, Double> INTENSITY = like(World.INTENSITY, "intensity", Dome::intensity, Dome::withIntensity);
    public static final SceneAttribute<Dome, Double> GAIN = like(World.GAIN, "light gain", Dome::gain, Dome::withGain);
    public static final SceneAttribute<Dome, Integer> LIGHT_COUNT =
            like(World.LIGHT_COUNT, "bright lights", Dome::lightCount, Dome::withLightCount);
    public static final SceneAttribute<Dome, Double> SOFTNESS =
            like(World.SOFTNESS, "shadow smoothing", Dome::softness, Dome::withSoftness);
    public static final SceneAttribute<Dome, Boolean> ON =
            new SceneAttribute<>("on", "on", ChoiceKind.YES_OR_NO, true, "", Dome::on, Dome::withOn);
    public static final SceneAttribute<Dome, Boolean> SOLO = like(World.SOLO, "solo", Dome::solo, Dome::withSolo);

    /** All attributes, in file order. */
    public static final List<SceneAttribute<Dome, ?>> ATTRIBUTES =
            List.of(ENVIRONMENT, ROTATION, TILT, ROLL, INTENSITY, GAIN, LIGHT_COUNT, SOFTNESS, ON, SOLO);

    /** Samples of a light that is hardly larger than the sun, and of a larger one. */
    private static final int SUN_SAMPLES = SceneLimits.MIN_LIGHT_SAMPLES;
    private static final int SAMPLES = AreaShape.DEFAULT.samples();
    /** Half-angle of a light with few samples, degrees. */
    private static final double SUN = 1;

    public Dome {
        SceneLimits.checkName(name);
        ROTATION.check(rotation.rotation());
        TILT.check(rotation.tilt());
        ROLL.check(rotation.roll());
        INTENSITY.check(intensity);
        GAIN.check(gain);
        LIGHT_COUNT.check(lightCount);
        SOFTNESS.check(softness);
    }

    /** Returns a dome without an image. */
    public static Dome of(String name) {
        return new Dome(name, Optional.empty(), DomeRotation.NONE, INTENSITY.initial(), GAIN.initial(), LIGHT_COUNT.initial(),
                SOFTNESS.initial(), ON.initial(), SOLO.initial());
    }

    /** Returns an attribute with the name, range and default of one of the world's environment. */
    private static <V> SceneAttribute<Dome, V> like(SceneAttribute<World, V> attribute, String title,
            Function<Dome, V> getter, BiFunction<Dome, V, Dome> setter) {
        return new SceneAttribute<>(attribute.name(), title, attribute.kind(), attribute.initial(), attribute.unit(), getter, setter);
    }

    /** Returns a clause that says why an attribute has no effect; empty if it has. */
    public Optional<String> inactiveReason(SceneAttribute<Dome, ?> attribute) {
        return image.isEmpty() && attribute != ENVIRONMENT ? Optional.of(Messages.tr("the dome has no image"))
                : !on && attribute != ON ? Optional.of(Messages.tr("the dome is off")) : Optional.empty();
    }

    /**
     * Returns the decoded image.
     *
     * @throws java.util.NoSuchElementException if it has none
     */
    public EnvironmentMap map() {
        return image.orElseThrow().map();
    }

    /** Returns the factor of its light, ≥ 0; 0 if it is off or without an image. */
    public double lightIntensity() {
        return on && image.isPresent() ? intensity * gain : 0;
    }

    /**
     * Returns the directional lights of its small bright parts. At least one stands for it, even if it is dark.
     *
     * @param isUsed test for names of other lights
     */
    EnvironmentLights brightLights(Predicate<String> isUsed) {
        return new EnvironmentLights(lights(map().brightLights(lightCount), lightCount, isUsed), intensity * gain);
    }

    /**
     * Returns directional lights that stand for all of its light, where nothing gathers its smooth light.
     *
     * @param count  maximum number
     * @param isUsed test for names of other lights
     */
    public List<Light> approximateLights(int count, Predicate<String> isUsed) {
        return new EnvironmentLights(lights(map().lights(count), count, isUsed), intensity * gain).lights();
    }

    private List<Light> lights(List<EnvironmentLight> sources, int count, Predicate<String> isUsed) {
        List<Light> lights = new ArrayList<>();
        String prefix = name;
        while (isAnyUsed(prefix, count, isUsed)) {
            prefix += "'";
        }
        for (EnvironmentLight source : sources) {
            Vec3 direction = rotation.toWorld().transformVector(source.direction());
            double spread = spread(source, direction);
            double maxChannel = Math.max(source.red(), Math.max(source.green(), source.blue()));
            lights.add(Light.of(prefix + " " + (lights.size() + 1), LightType.DIRECTIONAL)
                    .withDirection(direction.negated())
                    .withColor(maxChannel > 0 ? new Rgb(source.red() / maxChannel, source.green() / maxChannel, source.blue() / maxChannel)
                            : Rgb.BLACK)
                    .withOn(on)
                    .withSolo(solo && lightIntensity() > 0)
                    .withIntensity(Math.min(maxChannel * source.meanLength(), SceneLimits.MAX_ENVIRONMENT_LIGHT_INTENSITY))
                    .withArea(AreaShape.DEFAULT.withSpread(spread).withSamples(spread > SUN ? SAMPLES : SUN_SAMPLES)));
        }
        return lights;
    }

    /** Returns the half-angle of a light in degrees, at most its angle to the horizon: light from below would be lost to a floor. */
    private double spread(EnvironmentLight source, Vec3 direction) {
        double elevation = Math.toDegrees(StrictMath.asin(Math.min(Math.abs(direction.y()), 1)));
        return Math.min(source.spread() * softness, elevation);
    }

    private static boolean isAnyUsed(String name, int count, Predicate<String> isUsed) {
        return IntStream.rangeClosed(1, count).anyMatch(number -> isUsed.test(name + " " + number));
    }
}
