package lightning.scene;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.light.EnvironmentLights;
import lightning.scene.light.Light;
import lightning.scene.light.LightRig;
import lightning.scene.sky.Sky;
import lightning.scene.value.DomeRotation;
import lightning.scene.value.Fog;
import lightning.scene.value.SceneLimits;

/**
 * Surroundings of the shapes.
 *
 * @param ambience    factor of every material's ambient color, ≥ 0
 * @param background  linear color of rays that hit nothing, ≥ 0; replaced by an environment
 * @param image       environment map, visible in the background; it lights surfaces through gathering rays and the lights of its bright parts
 * @param dome        rotation of the environment
 * @param intensity   factor of the environment's image and light
 * @param gain        factor of the environment's light alone; its image stays
 * @param lightCount  maximum number of directional lights that represent its small bright parts
 * @param softness    spread of each light over its part, 0 … 1
 * @param solo        true if its light is soloed: if intensity and gain are not 0, all lights that are not solo are dark
 * @param meters      meters per scene unit, for photometric units of lights
 * @param fog         air between the shapes
 * @param sky         physical sky, which is the environment while it is on
 * @param domes       further environments with unique names, whose radiance is added in this order
 */
@RecordBuilder
public record World(double ambience, Rgb background, Optional<Environment> image, DomeRotation dome, double intensity, double gain,
        int lightCount, double softness, boolean solo, double meters, Fog fog, Sky sky, List<Dome> domes) implements WorldBuilder.With {
    public static final SceneAttribute<World, Double> AMBIENCE = new SceneAttribute<>("ambience", "ambience", "ambient light",
            NumericKind.number(0, SceneLimits.MAX_AMBIENCE, 0.1), 1.0, "", World::ambience, World::withAmbience);
    public static final SceneAttribute<World, Rgb> BACKGROUND = new SceneAttribute<>("background", "background",
            NumericKind.color(SceneLimits.MAX_EMISSION), Rgb.BLACK, "linear red, green, blue", World::background, World::withBackground);
    public static final SceneAttribute<World, Optional<Environment>> ENVIRONMENT = new SceneAttribute<>("environment", "environment",
            new ValueKind.EnvironmentKind(), Optional.empty(), "a Radiance HDR or OpenEXR file", World::image,
            World::withImage);
    public static final SceneAttribute<World, Double> ROTATION = new SceneAttribute<>("rotation", "environment rotation",
            NumericKind.degrees(-SceneLimits.MAX_ROTATION, SceneLimits.MAX_ROTATION, 5), 0.0, "degrees about y", World::rotation,
            World::withRotation);
    public static final SceneAttribute<World, Double> TILT = new SceneAttribute<>("tilt", "environment tilt",
            NumericKind.degrees(-SceneLimits.MAX_ROTATION, SceneLimits.MAX_ROTATION, 5), 0.0, "degrees about x, before rotation",
            world -> world.dome.tilt(), (world, v) -> world.withDome(world.dome.withTilt(v)));
    public static final SceneAttribute<World, Double> ROLL = new SceneAttribute<>("roll", "environment roll",
            NumericKind.degrees(-SceneLimits.MAX_ROTATION, SceneLimits.MAX_ROTATION, 5), 0.0, "degrees about z, before tilt",
            world -> world.dome.roll(), (world, v) -> world.withDome(world.dome.withRoll(v)));
    public static final SceneAttribute<World, Double> INTENSITY = new SceneAttribute<>("intensity", "environment intensity",
            NumericKind.number(0, SceneLimits.MAX_GROUP_INTENSITY, 0.1), 1.0, "multiplies the environment", World::intensity,
            World::withIntensity);
    public static final SceneAttribute<World, Double> GAIN = new SceneAttribute<>("gain", "environment light gain",
            NumericKind.number(0, SceneLimits.MAX_GROUP_INTENSITY, 0.1), 1.0, "multiplies the environment's light, not its image",
            World::gain, World::withGain);
    public static final SceneAttribute<World, Integer> LIGHT_COUNT = new SceneAttribute<>("lamps", "environment bright lights",
            NumericKind.integer(SceneLimits.MIN_LIGHT_SAMPLES, SceneLimits.MAX_LIGHT_SAMPLES), 16,
            "most lights for bright parts", World::lightCount,
            World::withLightCount);

    public static final SceneAttribute<World, Double> SOFTNESS = new SceneAttribute<>("softness", "environment shadow smoothing",
            NumericKind.number(0, 1, 0.1), 1.0, "0 = sharp shadows, 1 = smooth", World::softness, World::withSoftness);

    public static final SceneAttribute<World, Boolean> SOLO = new SceneAttribute<>("solo", "environment solo", ChoiceKind.YES_OR_NO, false,
            "", World::solo, World::withSolo);

    public static final SceneAttribute<World, Double> METERS = new SceneAttribute<>("meters", "meters per unit",
            NumericKind.number(SceneLimits.MIN_METERS, SceneLimits.MAX_METERS, 0.1), LightRig.METERS, "meters per scene unit",
            World::meters,
            World::withMeters);

    /** All attributes, in file order. */
    public static final List<SceneAttribute<World, ?>> ATTRIBUTES = Stream.of(
            List.<SceneAttribute<World, ?>>of(AMBIENCE, BACKGROUND, ENVIRONMENT, ROTATION, TILT, ROLL, INTENSITY, GAIN, LIGHT_COUNT,
                    SOFTNESS,
                    SOLO, METERS),
            FogAttributes.ALL, SkyAttributes.ALL).flatMap(List::stream).toList();

    /** Name of its own environment's lights. */
    static final String NAME = "environment";

    public static final World DEFAULT = new World(AMBIENCE.initial(), BACKGROUND.initial());

    public World {
        AMBIENCE.check(ambience);
        BACKGROUND.check(background);
        ROTATION.check(dome.rotation());
        TILT.check(dome.tilt());
        ROLL.check(dome.roll());
        INTENSITY.check(intensity);
        GAIN.check(gain);
        LIGHT_COUNT.check(lightCount);
        SOFTNESS.check(softness);
        METERS.check(meters);
        domes = DomeNames.check(domes);
    }

    /** Creates a world without an environment. */
    public World(double ambience, Rgb background) {
        this(ambience, background, ENVIRONMENT.initial(), DomeRotation.NONE, INTENSITY.initial(), GAIN.initial(),
                LIGHT_COUNT.initial(), SOFTNESS.initial(), SOLO.initial(), METERS.initial(), Fog.NONE, Sky.NONE, List.of());
    }

    /** Returns a clause that says why an attribute has no effect in this world; empty if it has. */
    public Optional<String> inactiveReason(SceneAttribute<World, ?> attribute) {
        boolean needsEnvironment = attribute == ROTATION || attribute == TILT || attribute == ROLL || attribute == INTENSITY
                || attribute == GAIN || attribute == LIGHT_COUNT
                || attribute == SOFTNESS || attribute == SOLO;
        if (needsEnvironment && environment().isEmpty()) {
            return Optional.of(Messages.tr("the scene has no environment"));
        }
        boolean needsSky = SkyAttributes.ALL.contains(attribute) && attribute != SkyAttributes.ON;
        if (needsSky && !sky.on()) {
            return Optional.of(Messages.tr("the physical sky is off"));
        }
        if (sky.on() && attribute == LIGHT_COUNT) {
            return Optional.of(Messages.tr("the sun is the only bright light of a physical sky"));
        }
        if (sky.on() && attribute == ENVIRONMENT) {
            return Optional.of(Messages.tr("the physical sky is on"));
        }
        boolean needsFog = FogAttributes.ALL.contains(attribute) && attribute != FogAttributes.DENSITY;
        return needsFog && !fog.isPresent() ? Optional.of(Messages.tr("the scene has no fog")) : Optional.empty();
    }

    /** Returns the environment: the sky while it is on, otherwise the image. */
    public Optional<Environment> environment() {
        return sky.on() ? Optional.of(sky.environment()) : image;
    }

    /** Returns this world with an image or no environment, and without a sky. */
    public World withEnvironment(Optional<Environment> v) {
        return with(world -> world.image(v).sky(sky.withOn(false)));
    }

    /** Returns the rotation of the environment about y, degrees. */
    public double rotation() {
        return dome.rotation();
    }

    public World withRotation(double v) {
        return withDome(dome.withRotation(v));
    }

    /** Returns the factor of the environment's light, ≥ 0; 0 without an environment. */
    public double lightIntensity() {
        return environment().isEmpty() ? 0 : intensity * gain;
    }

    /**
     * Returns all environments, in the order in which their radiances are summed: its own, then the domes with an image. Looks up the sky, so
     * callers do this once for many rays.
     */
    public List<Dome> environments() {
        Stream<Dome> own = environment().stream()
                .map(e -> new Dome(NAME, Optional.of(e), dome, intensity, gain, lightCount, softness, true, solo));
        return Stream.concat(own, domes.stream().filter(d -> d.image().isPresent())).toList();
    }

    /** Returns the images of its environments, each once; not those of skies. */
    public Set<EnvironmentMap> images() {
        Set<EnvironmentMap> images = Collections.newSetFromMap(new IdentityHashMap<>());
        Stream.concat(image.stream(), domes.stream().flatMap(d -> d.image().stream())).forEach(e -> images.add(e.map()));
        return images;
    }

    /** Returns whether it has any environment, on or off. */
    public boolean hasEnvironment() {
        return hasOwnEnvironment() || domes.stream().anyMatch(d -> d.image().isPresent());
    }

    /** Returns whether it has an environment besides its domes. */
    boolean hasOwnEnvironment() {
        return sky.on() || image.isPresent();
    }

    /** Returns whether any environment lights the scene, unless a solo mutes it. */
    public boolean hasEnvironmentLight() {
        return lightIntensity() > 0 || domes.stream().anyMatch(d -> d.lightIntensity() > 0);
    }

    /**
     * Returns the directional lights of the small bright parts of each environment.
     *
     * @param isUsed test for names of other lights
     */
    List<EnvironmentLights> environmentLights(Predicate<String> isUsed) {
        return lights(isUsed, Dome::brightLights, EnvironmentLights::units);
    }

    /**
     * Returns directional lights that stand for all light of its environments that are on, where nothing gathers their smooth light.
     *
     * @param isUsed test for names of other lights
     */
    List<Light> approximateLights(Predicate<String> isUsed) {
        BiFunction<Dome, Predicate<String>, List<Light>> approximate =
                (layer, used) -> layer.on() ? layer.approximateLights(layer.lightCount(), used) : List.of();
        return lights(isUsed, approximate, added -> added).stream().flatMap(List::stream).toList();
    }

    private <T> List<T> lights(Predicate<String> isUsed, BiFunction<Dome, Predicate<String>, T> lightsOf,
            Function<T, List<Light>> list) {
        List<T> lights = new ArrayList<>();
        Set<String> names = new HashSet<>();
        for (Dome layer : environments()) {
            T added = lightsOf.apply(layer, name -> isUsed.test(name) || names.contains(name));
            list.apply(added).forEach(light -> names.add(light.name()));
            lights.add(added);
        }
        return lights;
    }

    /** Returns the dome of that name. */
    public Optional<Dome> dome(String name) {
        return domes.stream().filter(d -> d.name().equals(name)).findFirst();
    }

    /**
     * Returns this world with the dome of a name replaced.
     *
     * @throws IllegalArgumentException if there is no such dome, or another one has the new name
     */
    public World withDome(String name, Dome v) {
        if (dome(name).isEmpty()) {
            throw new IllegalArgumentException("there is no dome " + Quote.of(name));
        }
        return withDomes(domes.stream().map(d -> d.name().equals(name) ? v : d).toList());
    }

    /** Returns this world without any environment. */
    public World withoutEnvironments() {
        return withEnvironment(Optional.empty()).withDomes(List.of());
    }

}
