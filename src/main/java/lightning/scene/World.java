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
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.light.EnvironmentLights;
import lightning.scene.light.Light;
import lightning.scene.light.LightRig;
import lightning.scene.sky.Sky;
import lightning.scene.value.Fog;
import lightning.scene.value.SceneLimits;

/**
 * Surroundings of the shapes.
 *
 * @param ambience   factor of every material's ambient color, ≥ 0
 * @param background linear color of rays that hit nothing, ≥ 0; replaced by an environment
 * @param domes      environments with unique names, whose radiance is added in this order; the world's own has the name {@link Dome#OWN},
 *                   comes first, and is absent if it has its initial values
 * @param meters     meters per scene unit, for photometric units of lights
 * @param fog        air between the shapes
 */
@RecordBuilder
public record World(double ambience, Rgb background, List<Dome> domes, double meters, Fog fog) implements WorldBuilder.With {
    public static final SceneAttribute<World, Double> AMBIENCE = new SceneAttribute<>("ambience", "ambience", "ambient light",
            NumericKind.number(0, SceneLimits.MAX_AMBIENCE, 0.1), 1.0, "", World::ambience, World::withAmbience);
    public static final SceneAttribute<World, Rgb> BACKGROUND = new SceneAttribute<>("background", "background",
            NumericKind.color(SceneLimits.MAX_EMISSION), Rgb.BLACK, "linear red, green, blue", World::background, World::withBackground);
    public static final SceneAttribute<World, Optional<Environment>> ENVIRONMENT = own(Dome.ENVIRONMENT, "environment", "environment")
            .inactiveIf(world -> world.sky().on() ? Optional.of(Messages.tr("the physical sky is on")) : Optional.empty());
    public static final SceneAttribute<World, Double> ROTATION = own(Dome.ROTATION);
    public static final SceneAttribute<World, Double> TILT = own(Dome.TILT);
    public static final SceneAttribute<World, Double> ROLL = own(Dome.ROLL);
    public static final SceneAttribute<World, Double> INTENSITY = own(Dome.INTENSITY);
    public static final SceneAttribute<World, Double> GAIN = own(Dome.GAIN);
    public static final SceneAttribute<World, Integer> LIGHT_COUNT = own(Dome.LIGHT_COUNT).inactiveIf(world -> !world.sky().on()
            ? missing(world) : Optional.of(Messages.tr("the sun is the only bright light of a physical sky")));
    public static final SceneAttribute<World, Double> SOFTNESS = own(Dome.SOFTNESS);
    public static final SceneAttribute<World, Boolean> SOLO = own(Dome.SOLO);

    public static final SceneAttribute<World, Double> METERS = new SceneAttribute<>("meters", "meters per unit",
            NumericKind.number(SceneLimits.MIN_METERS, SceneLimits.MAX_METERS, 0.1), LightRig.METERS, "meters per scene unit",
            World::meters,
            World::withMeters);

    /** Attributes of its own environment: those of its strength come first. */
    public static final List<SceneAttribute<World, ?>> OWN =
            List.of(INTENSITY, GAIN, ENVIRONMENT, ROTATION, TILT, ROLL, LIGHT_COUNT, SOFTNESS, SOLO);

    /** All attributes, in file order. */
    public static final List<SceneAttribute<World, ?>> ATTRIBUTES = Stream.of(
            List.of(AMBIENCE, BACKGROUND, ENVIRONMENT, ROTATION, TILT, ROLL, INTENSITY, GAIN, LIGHT_COUNT, SOFTNESS, SOLO, METERS),
            FogAttributes.ALL, SkyAttributes.ALL).flatMap(List::stream).toList();

    public static final World DEFAULT = new World(AMBIENCE.initial(), BACKGROUND.initial());

    public World {
        AMBIENCE.check(ambience);
        BACKGROUND.check(background);
        METERS.check(meters);
        domes = DomeNames.check(domes);
    }

    /** Creates a world without an environment. */
    public World(double ambience, Rgb background) {
        this(ambience, background, List.of(), METERS.initial(), Fog.NONE);
    }

    /** Returns an attribute of the world's own environment. */
    private static <V> SceneAttribute<World, V> own(SceneAttribute<Dome, V> attribute) {
        return own(attribute, attribute.name(), "environment " + attribute.title());
    }

    private static <V> SceneAttribute<World, V> own(SceneAttribute<Dome, V> attribute, String name, String title) {
        return new SceneAttribute<World, V>(name, title, attribute.kind(), attribute.initial(), attribute.unit(),
                world -> attribute.get(world.own()), (world, v) -> {
                    attribute.kind().check(title, v);
                    return world.withOwn(dome -> attribute.with(dome, v));
                }).inactiveIf(World::missing);
    }

    private static Optional<String> missing(World world) {
        return world.own().isPresent() ? Optional.empty() : Optional.of(Messages.tr("the scene has no environment"));
    }

    /** Returns its own environment; without an image if it has none. */
    public Dome own() {
        return domes.isEmpty() || !domes.getFirst().isOwn() ? Dome.INITIAL : domes.getFirst();
    }

    /** Returns this world with its own environment changed. */
    public World withOwn(UnaryOperator<Dome> change) {
        return withDomes(Stream.concat(Stream.of(change.apply(own())), named().stream()).toList());
    }

    /** Returns the environments with names. */
    public List<Dome> named() {
        return domes.isEmpty() || !domes.getFirst().isOwn() ? domes : domes.subList(1, domes.size());
    }

    /** Returns this world with other environments besides its own. */
    public World withNamed(List<Dome> v) {
        return withDomes(Stream.concat(Stream.of(own()), v.stream()).toList());
    }

    /** Returns the physical sky of its own environment. */
    public Sky sky() {
        return own().sky();
    }

    public World withSky(Sky v) {
        return withOwn(dome -> dome.withSky(v));
    }

    /** Returns the image of its own environment: the sky while it is on. */
    public Optional<Environment> environment() {
        return own().environment();
    }

    /** Returns this world with an image or no environment of its own, and without a sky. */
    public World withEnvironment(Optional<Environment> v) {
        return withOwn(dome -> dome.withImage(v).withSky(dome.sky().withOn(false)));
    }

    /**
     * Returns the domes with an image, on or off, in the order in which their radiances are summed. Looks up the image of the sky, so callers
     * do this once for many rays.
     */
    public List<Dome> environments() {
        return domes.stream().filter(Dome::isPresent).map(Dome::withImageOfSky).toList();
    }

    /** Returns the images of its environments, each once; not those of skies. */
    public Set<EnvironmentMap> images() {
        Set<EnvironmentMap> images = Collections.newSetFromMap(new IdentityHashMap<>());
        domes.stream().flatMap(dome -> dome.image().stream()).forEach(e -> images.add(e.map()));
        return images;
    }

    /** Returns whether it has any environment, on or off. */
    public boolean hasEnvironment() {
        return domes.stream().anyMatch(Dome::isPresent);
    }

    /** Returns whether any environment lights the scene, unless a solo mutes it. */
    public boolean hasEnvironmentLight() {
        return domes.stream().anyMatch(d -> d.lightIntensity() > 0);
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

    /** Returns the dome of a name that files and people use; never the world's own. */
    public Optional<Dome> dome(String name) {
        return named().stream().filter(d -> d.name().equals(name)).findFirst();
    }

    /** Returns the dome of a name, or the world's own, which always exists. */
    public Optional<Dome> domeOrOwn(String name) {
        return name.equals(Dome.OWN) ? Optional.of(own()) : dome(name);
    }

    /**
     * Returns this world with the dome of a name replaced.
     *
     * @throws RefusalException if there is no such dome, or another one has the new name
     */
    public World withDome(String name, Dome v) {
        if (name.equals(Dome.OWN)) {
            return withOwn(_ -> v);
        }
        if (dome(name).isEmpty()) {
            throw new RefusalException("there is no dome " + Quote.of(name));
        }
        return withDomes(domes.stream().map(d -> d.name().equals(name) ? v : d).toList());
    }

    /** Returns this world without any environment. */
    public World withoutEnvironments() {
        return withEnvironment(Optional.empty()).withNamed(List.of());
    }
}
