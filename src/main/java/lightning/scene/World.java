package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.base.text.Messages;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentLight;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Light;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import lightning.scene.value.SceneLimits;

/**
 * Surroundings of the shapes.
 *
 * @param ambience    factor of every material's ambient color, ≥ 0
 * @param background  linear color of rays that hit nothing, ≥ 0; replaced by an environment
 * @param environment environment map, visible in the background and used as a light
 * @param rotation    rotation of the environment about y, degrees
 * @param intensity   factor of the environment's image and light
 * @param gain        factor of the environment's light alone; its image stays
 * @param lightCount  number of directional lights that represent it
 * @param softness    spread of each light over its region, 0 … 1
 * @param solo        true if its light is soloed: if intensity and gain are not 0, all lights that are not solo are dark
 * @param meters      meters per scene unit, for photometric units of lights
 */
@RecordBuilder
public record World(double ambience, Rgb background, Optional<Environment> environment, double rotation, double intensity, double gain,
        int lightCount, double softness, boolean solo, double meters) implements WorldBuilder.With {
    public static final SceneAttribute<World, Double> AMBIENCE = new SceneAttribute<>("ambience", "ambience", "ambient light",
            NumericKind.number(0, SceneLimits.MAX_AMBIENCE, 0.1), 1.0, "", World::ambience, World::withAmbience);
    public static final SceneAttribute<World, Rgb> BACKGROUND = new SceneAttribute<>("background", "background",
            NumericKind.color(SceneLimits.MAX_EMISSION), Rgb.BLACK, "linear red, green, blue", World::background, World::withBackground);
    public static final SceneAttribute<World, Optional<Environment>> ENVIRONMENT = new SceneAttribute<>("environment", "environment",
            new ValueKind.EnvironmentKind(), Optional.empty(), "a Radiance HDR or OpenEXR file", World::environment,
            World::withEnvironment);
    public static final SceneAttribute<World, Double> ROTATION = new SceneAttribute<>("rotation", "environment rotation",
            NumericKind.degrees(-SceneLimits.MAX_ROTATION, SceneLimits.MAX_ROTATION, 5), 0.0, "degrees about y", World::rotation,
            World::withRotation);
    public static final SceneAttribute<World, Double> INTENSITY = new SceneAttribute<>("intensity", "environment intensity",
            NumericKind.number(0, SceneLimits.MAX_GROUP_INTENSITY, 0.1), 1.0, "multiplies the environment", World::intensity,
            World::withIntensity);
    public static final SceneAttribute<World, Double> GAIN = new SceneAttribute<>("gain", "environment light gain",
            NumericKind.number(0, SceneLimits.MAX_GROUP_INTENSITY, 0.1), 1.0, "multiplies the environment's light, not its image",
            World::gain, World::withGain);
    public static final SceneAttribute<World, Integer> LIGHT_COUNT = new SceneAttribute<>("lamps", "environment samples",
            NumericKind.integer(SceneLimits.MIN_LIGHT_SAMPLES, SceneLimits.MAX_LIGHT_SAMPLES), 16,
            "directional lights", World::lightCount,
            World::withLightCount);

    public static final SceneAttribute<World, Double> SOFTNESS = new SceneAttribute<>("softness", "environment shadow smoothing",
            NumericKind.number(0, 1, 0.1), 0.0, "0 = sharp shadows, 1 = smooth", World::softness, World::withSoftness);

    public static final SceneAttribute<World, Boolean> SOLO = new SceneAttribute<>("solo", "environment solo", ChoiceKind.YES_OR_NO, false,
            "", World::solo, World::withSolo);

    public static final SceneAttribute<World, Double> METERS = new SceneAttribute<>("meters", "meters per unit",
            NumericKind.number(SceneLimits.MIN_METERS, SceneLimits.MAX_METERS, 0.1), LightRig.METERS, "meters per scene unit",
            World::meters,
            World::withMeters);

    /** All attributes, in file order. */
    public static final List<SceneAttribute<World, ?>> ATTRIBUTES =
            List.of(AMBIENCE, BACKGROUND, ENVIRONMENT, ROTATION, INTENSITY, GAIN, LIGHT_COUNT, SOFTNESS, SOLO, METERS);

    /** Number of environment lights that leave neither stripes nor much grain: docs/decisions/0164-first-steps-of-an-artist.md. */
    private static final int SOFT_LIGHTS = 48;

    /** Samples of a spread environment light: the minimum, because there are many lights. */
    private static final int SAMPLES_PER_LIGHT = SceneLimits.MIN_LIGHT_SAMPLES;

    public static final World DEFAULT = new World(AMBIENCE.initial(), BACKGROUND.initial());

    public World {
        AMBIENCE.check(ambience);
        BACKGROUND.check(background);
        ROTATION.check(rotation);
        INTENSITY.check(intensity);
        GAIN.check(gain);
        LIGHT_COUNT.check(lightCount);
        SOFTNESS.check(softness);
        METERS.check(meters);
    }

    /** Creates a world without an environment. */
    public World(double ambience, Rgb background) {
        this(ambience, background, ENVIRONMENT.initial(), ROTATION.initial(), INTENSITY.initial(), GAIN.initial(),
                LIGHT_COUNT.initial(), SOFTNESS.initial(), SOLO.initial(), METERS.initial());
    }

    /**
     * Returns this world with enough environment lights, spread over their regions, for shadows without stripes, if {@code before} has no
     * environment and nothing else was chosen. The initial values of scene files are coarser, because old files rely on them.
     */
    public World withSoftLights(World before) {
        boolean isFirst = before.environment.isEmpty() && environment.isPresent() && lightCount == LIGHT_COUNT.initial()
                && softness == SOFTNESS.initial();
        return isFirst ? withLightCount(SOFT_LIGHTS).withSoftness(1) : this;
    }

    /** Returns a clause that says why an attribute has no effect in this world; empty if it has. */
    public Optional<String> inactiveReason(SceneAttribute<World, ?> attribute) {
        boolean needsEnvironment = attribute == ROTATION || attribute == INTENSITY || attribute == GAIN || attribute == LIGHT_COUNT
                || attribute == SOFTNESS || attribute == SOLO;
        return needsEnvironment && environment.isEmpty() ? Optional.of(Messages.tr("the scene has no environment")) : Optional.empty();
    }

    /** Returns the factor of the environment's light, ≥ 0; 0 without an environment. */
    public double lightIntensity() {
        return environment.isEmpty() ? 0 : intensity * gain;
    }

    /**
     * Returns the directional lights of its environment; none without one.
     *
     * @param isUsed test for names of other lights
     */
    List<Light> environmentLights(Predicate<String> isUsed) {
        if (environment.isEmpty()) {
            return List.of();
        }
        List<Light> lights = new ArrayList<>();
        double cos = Transform.cosDegrees(rotation);
        double sin = Transform.sinDegrees(rotation);
        String name = "environment";
        while (isAnyUsed(name, isUsed)) {
            name += "'";
        }
        for (EnvironmentLight source : environment.get().map().lights(lightCount)) {
            Vec3 direction = source.direction();
            double maxChannel = Math.max(source.red(), Math.max(source.green(), source.blue()));
            lights.add(Light.of(name + " " + (lights.size() + 1), LightType.DIRECTIONAL)
                    .withDirection(new Vec3(-(direction.x() * cos + direction.z() * sin), -direction.y(),
                            direction.x() * sin - direction.z() * cos))
                    .withColor(maxChannel > 0 ? new Rgb(source.red() / maxChannel, source.green() / maxChannel, source.blue() / maxChannel)
                            : Rgb.BLACK)
                    .withSolo(solo && lightIntensity() > 0)
                    .withIntensity(Math.min(maxChannel * source.meanLength() * intensity * gain,
                            SceneLimits.MAX_ENVIRONMENT_LIGHT_INTENSITY))
                    .withArea(AreaShape.DEFAULT.withSpread(spread(source))
                            .withSamples(SAMPLES_PER_LIGHT)));
        }
        return lights;
    }

    /** Returns the half-angle of a light in degrees, at most its angle to the horizon: light from below would be lost to a floor. */
    private double spread(EnvironmentLight source) {
        double elevation = Math.toDegrees(StrictMath.asin(Math.min(Math.abs(source.direction().y()), 1)));
        return Math.min(source.spread() * softness, elevation);
    }

    private boolean isAnyUsed(String name, Predicate<String> isUsed) {
        return IntStream.rangeClosed(1, lightCount).anyMatch(number -> isUsed.test(name + " " + number));
    }
}
