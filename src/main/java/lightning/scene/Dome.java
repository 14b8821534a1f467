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
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.light.AreaShape;
import lightning.scene.light.EnvironmentLights;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.sky.Sky;
import lightning.scene.value.DomeRotation;
import lightning.scene.value.SceneLimits;

/**
 * Environment of a scene, whose radiance is added to that of the others. It is visible in the background, and lights surfaces through gathering
 * rays and the lights of its bright parts.
 *
 * @param name       unique among domes, lights, light groups, shapes and groups; {@link #OWN} for the world's own environment, which files
 *                   write in the world's block
 * @param image      environment map; a dome without one and without a sky has no effect
 * @param sky        physical sky, which replaces the image while it is on; off unless it is the world's own
 * @param rotation   rotation of the image
 * @param intensity  factor of its image and light
 * @param gain       factor of its light alone; its image stays
 * @param lightCount maximum number of directional lights that represent its small bright parts
 * @param softness   spread of each light over its part, 0 … 1
 * @param on         false if it is neither visible nor lights anything
 * @param solo       true if its light is soloed: if it is not dark, all lights and environments that are not solo are dark
 */
@RecordBuilder
public record Dome(String name, Optional<Environment> image, Sky sky, DomeRotation rotation, double intensity, double gain, int lightCount,
        double softness, boolean on, boolean solo) implements DomeBuilder.With {
    /** Name of the world's own environment. */
    public static final String OWN = "";

    public static final SceneAttribute<Dome, Optional<Environment>> ENVIRONMENT = new SceneAttribute<>("environment", "image",
            new ValueKind.EnvironmentKind(), Optional.empty(), "a Radiance HDR or OpenEXR file", Dome::image, Dome::withImage);
    public static final SceneAttribute<Dome, Double> ROTATION = ofImage("rotation", "rotation",
            NumericKind.degrees(-SceneLimits.MAX_ROTATION, SceneLimits.MAX_ROTATION, 5), 0.0, "degrees about y",
            dome -> dome.rotation.rotation(), (dome, v) -> dome.withRotation(dome.rotation.withRotation(v)));
    public static final SceneAttribute<Dome, Double> TILT = ofImage("tilt", "tilt",
            NumericKind.degrees(-SceneLimits.MAX_ROTATION, SceneLimits.MAX_ROTATION, 5), 0.0, "degrees about x, before rotation",
            dome -> dome.rotation.tilt(), (dome, v) -> dome.withRotation(dome.rotation.withTilt(v)));
    public static final SceneAttribute<Dome, Double> ROLL = ofImage("roll", "roll",
            NumericKind.degrees(-SceneLimits.MAX_ROTATION, SceneLimits.MAX_ROTATION, 5), 0.0, "degrees about z, before tilt",
            dome -> dome.rotation.roll(), (dome, v) -> dome.withRotation(dome.rotation.withRoll(v)));
    public static final SceneAttribute<Dome, Double> INTENSITY = ofImage("intensity", "intensity",
            NumericKind.number(0, SceneLimits.MAX_GROUP_INTENSITY, 0.1), 1.0, "multiplies the environment", Dome::intensity,
            Dome::withIntensity);
    public static final SceneAttribute<Dome, Double> GAIN = ofImage("gain", "light gain",
            NumericKind.number(0, SceneLimits.MAX_GROUP_INTENSITY, 0.1), 1.0, "multiplies the environment's light, not its image",
            Dome::gain, Dome::withGain);
    public static final SceneAttribute<Dome, Integer> LIGHT_COUNT = ofImage("lamps", "bright lights",
            NumericKind.integer(SceneLimits.MIN_LIGHT_SAMPLES, SceneLimits.MAX_LIGHT_SAMPLES), 16, "most lights for bright parts",
            Dome::lightCount, Dome::withLightCount);
    public static final SceneAttribute<Dome, Double> SOFTNESS = ofImage("softness", "shadow smoothing",
            NumericKind.number(0, 1, 0.1), 1.0, "0 = sharp shadows, 1 = smooth", Dome::softness, Dome::withSoftness);
    public static final SceneAttribute<Dome, Boolean> ON =
            new SceneAttribute<>("on", "on", ChoiceKind.YES_OR_NO, true, "", Dome::on, Dome::withOn);
    public static final SceneAttribute<Dome, Boolean> SOLO =
            new SceneAttribute<>("solo", "solo", ChoiceKind.YES_OR_NO, false, "", Dome::solo, Dome::withSolo);

    /** All attributes, in file order. */
    public static final List<SceneAttribute<Dome, ?>> ATTRIBUTES =
            List.of(ENVIRONMENT, ROTATION, TILT, ROLL, INTENSITY, GAIN, LIGHT_COUNT, SOFTNESS, ON, SOLO);

    /** The world's own environment without an image. */
    static final Dome INITIAL = of(OWN);

    /** Samples of a light that is hardly larger than the sun, and of a larger one. */
    private static final int SUN_SAMPLES = SceneLimits.MIN_LIGHT_SAMPLES;
    private static final int SAMPLES = AreaShape.DEFAULT.samples();
    /** Half-angle of a light with few samples, degrees. */
    private static final double SUN = 1;

    public Dome {
        if (!name.equals(OWN)) {
            SceneLimits.checkName(name);
        }
        ROTATION.check(rotation.rotation());
        TILT.check(rotation.tilt());
        ROLL.check(rotation.roll());
        INTENSITY.check(intensity);
        GAIN.check(gain);
        LIGHT_COUNT.check(lightCount);
        SOFTNESS.check(softness);
    }

    /** Returns an attribute that has an effect while the dome has an image and is on. */
    private static <V> SceneAttribute<Dome, V> ofImage(String name, String title, ValueKind<V> kind, V initial, String unit,
            Function<Dome, V> getter, BiFunction<Dome, V, Dome> setter) {
        return new SceneAttribute<>(name, title, kind, initial, unit, getter, setter).inactiveIf(
                dome -> dome.image.isEmpty() ? Optional.of(Messages.tr("the dome has no image"))
                        : dome.on ? Optional.empty() : Optional.of(Messages.tr("the dome is off")));
    }

    /** Returns a dome without an image. */
    public static Dome of(String name) {
        return new Dome(name, Optional.empty(), Sky.NONE, DomeRotation.NONE, INTENSITY.initial(), GAIN.initial(), LIGHT_COUNT.initial(),
                SOFTNESS.initial(), ON.initial(), SOLO.initial());
    }

    /** Returns whether it is the world's own environment. */
    public boolean isOwn() {
        return name.equals(OWN);
    }

    /** Returns whether it has an image or a sky. */
    public boolean isPresent() {
        return sky.on() || image.isPresent();
    }

    /** Returns its image: that of the sky while it is on. */
    public Optional<Environment> environment() {
        return sky.on() ? Optional.of(sky.environment()) : image;
    }

    /** Returns this dome with the image of its sky, which is on, instead of the sky. */
    Dome withImageOfSky() {
        return sky.on() ? withImage(environment()).withSky(Sky.NONE) : this;
    }

    /**
     * Returns the decoded image, not that of the sky.
     *
     * @throws java.util.NoSuchElementException if it has none
     */
    public EnvironmentMap map() {
        return image.orElseThrow().map();
    }

    /** Returns the factor of its light, ≥ 0; 0 if it is off or without an image. */
    public double lightIntensity() {
        return on && isPresent() ? intensity * gain : 0;
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
        String prefix = isOwn() ? "environment" : name;
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
