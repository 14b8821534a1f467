package lightning.scene;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.base.text.Messages;
import lightning.scene.SceneElement.OfDome;
import lightning.scene.SceneElement.OfLight;
import lightning.scene.light.Light;
import lightning.scene.light.LightRig;
import lightning.scene.value.SceneLimits;

/** Part of a picture's light. All contributions add up to the picture; those of lights and environments have a fader. */
public sealed interface Contribution permits OfLight, OfDome, Contribution.OfAmbience, Contribution.OfRest {
    /** The world's own environment. */
    Contribution ENVIRONMENT = new OfDome(Dome.OWN);

    /** Ambient light. */
    record OfAmbience() implements Contribution {}

    /** Light that no weight changes: glow without a bulb, the background color, and ambient light of fog. */
    record OfRest() implements Contribution {}

    /** Returns the contribution of a light. */
    static Contribution of(Light light) {
        return new OfLight(light.name());
    }

    /** Returns the contributions of the {@link World#environments}, in their order. */
    static List<Contribution> environments(Scene scene) {
        return scene.world().domes().stream().filter(Dome::isPresent).<Contribution>map(dome -> new OfDome(dome.name())).toList();
    }

    /** Returns the contributions of lights and environments, on or off, in the scene's order. */
    static List<Contribution> sources(Scene scene) {
        return Stream.concat(scene.lights().stream().map(Contribution::of), environments(scene).stream()).toList();
    }

    /** Returns all contributions: the {@link #sources}, ambient light, and the rest. */
    static List<Contribution> all(Scene scene) {
        return Stream.concat(sources(scene).stream(), Stream.of(new OfAmbience(), new OfRest())).toList();
    }

    /** Returns the {@link #sources} that shine. */
    static List<Contribution> shining(Scene scene) {
        return sources(scene).stream().filter(part -> part.isShining(scene)).toList();
    }

    /** Returns the contribution of a name, whether it shines or not. */
    static Optional<Contribution> named(Scene scene, String name) {
        return all(scene).stream().filter(part -> part.name(scene).equals(name)).findFirst();
    }

    /** Returns its name in files and JSON, which no other contribution and no light group of the scene has. */
    default String name(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> name;
            case OfDome(String name) -> name.equals(Dome.OWN) ? unusedName(scene, "environment") : name;
            case OfAmbience _ -> unusedName(scene, "ambience");
            case OfRest _ -> unusedName(scene, "rest");
        };
    }

    /** Returns its name for people, in their language; as unique as {@link #name}. */
    default String title(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> name;
            case OfDome(String name) -> name.equals(Dome.OWN) ? unusedName(scene, Messages.tr("environment")) : name;
            case OfAmbience _ -> unusedName(scene, Messages.tr("ambient light"));
            case OfRest _ -> unusedName(scene, Messages.tr("other light"));
        };
    }

    /** Returns a name, with the number 2 or a later one if a light, a light group or a dome has it. */
    private static String unusedName(Scene scene, String name) {
        String unused = name;
        for (int n = 2; scene.rig().isNameUsed(unused) || scene.world().dome(unused).isPresent(); n++) {
            unused = name + " " + n;
        }
        return unused;
    }

    /** Returns the light of a scene; empty for other contributions, and for a light that the scene does not have. */
    default Optional<Light> light(Scene scene) {
        return this instanceof OfLight(String name) ? scene.light(name) : Optional.empty();
    }

    /** Returns its index among the {@link World#environments}; −1 for other contributions, and for a dome without an image. */
    default int environmentIndex(Scene scene) {
        return this instanceof OfLight ? -1 : environments(scene).indexOf(this);
    }

    /** Returns the indices of its lights among the {@link LightRig#effectiveLights}, in their order: a light, or an environment's bright parts. */
    default int[] effectiveLights(Scene scene) {
        int first = this instanceof OfLight(String name) ? scene.rig().indexOf(name) : -1;
        int environment = environmentIndex(scene);
        return first >= 0 ? new int[] {first} : environment < 0 ? new int[0]
                : IntStream.range(scene.rig().environmentStart(environment), scene.rig().environmentStart(environment + 1)).toArray();
    }

    /** Returns whether the scene has it. */
    default boolean isIn(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> scene.light(name).isPresent();
            case OfDome(String name) -> scene.world().domeOrOwn(name).filter(dome -> !dome.isOwn() || dome.isPresent()).isPresent();
            case OfAmbience _,OfRest _ -> true;
        };
    }

    /** Returns whether it contributes to the picture: it is on and not muted by another's solo. */
    default boolean isShining(Scene scene) {
        return switch (this) {
            case OfLight _ -> light(scene).filter(scene::isActive).isPresent();
            case OfDome(String name) -> scene.world().domeOrOwn(name).filter(dome -> dome.lightIntensity() > 0).isPresent()
                    && scene.rig().isEnvironmentActive(environmentIndex(scene));
            case OfAmbience _ -> scene.world().ambience() > 0;
            case OfRest _ -> true;
        };
    }

    /** Returns the maximum intensity. */
    default double maxIntensity() {
        return this instanceof OfLight ? SceneLimits.MAX_INTENSITY
                : this instanceof OfAmbience ? SceneLimits.MAX_AMBIENCE : SceneLimits.MAX_GROUP_INTENSITY;
    }

    /**
     * Returns the values of its fader. An environment is on unless its light is dark.
     *
     * @throws IllegalArgumentException if the scene does not have the light or dome
     */
    default FaderValues values(Scene scene) {
        World world = scene.world();
        return switch (this) {
            case OfLight element -> {
                Light light = element.get(scene);
                yield new FaderValues(light.intensity(), Optional.of(light.color()), light.on(), light.solo());
            }
            case OfDome element -> {
                Dome dome = element.get(scene);
                yield new FaderValues(dome.intensity(), Optional.empty(), dome.isOwn() ? dome.lightIntensity() > 0 : dome.on(),
                        dome.solo());
            }
            case OfAmbience _ -> new FaderValues(world.ambience(), Optional.empty(), world.ambience() > 0, false);
            case OfRest _ -> new FaderValues(1, Optional.empty(), true, false);
        };
    }

    /**
     * Returns the scene with other {@link #values}. A muted environment has a light gain of 0, which leaves its image; a muted dome is off. What
     * a contribution does not have is ignored.
     *
     * @throws IllegalArgumentException if the scene does not have the light or dome, or a value is out of range
     */
    default Scene with(Scene scene, UnaryOperator<FaderValues> change) {
        FaderValues before = values(scene);
        FaderValues v = change.apply(before);
        if (v.equals(before)) {
            return scene;
        }
        return switch (this) {
            case OfLight element -> {
                Light light = element.get(scene);
                Rgb color = v.color().orElse(light.color());
                yield scene.withLight(light.withIntensity(v.intensity()).withColor(color).withOn(v.on()).withSolo(v.solo()));
            }
            case OfDome element -> {
                Dome dome = element.get(scene).withIntensity(v.intensity()).withSolo(v.solo());
                Dome switched = !dome.isOwn() ? dome.withOn(v.on()) : v.on() == before.on() ? dome : v.on() ? lit(dome) : dome.withGain(0);
                yield scene.withWorld(scene.world().withDome(element.name(), switched));
            }
            case OfAmbience _ -> scene.withWorld(scene.world().withAmbience(v.on() ? v.intensity() : 0));
            case OfRest _ -> scene;
        };
    }

    /** Returns a dark environment with a light intensity above 0. Files of earlier versions muted the environment with its intensity. */
    private static Dome lit(Dome dome) {
        return dome.withIntensity(dome.intensity() > 0 ? dome.intensity() : Dome.INTENSITY.initial())
                .withGain(dome.gain() > 0 ? dome.gain() : Dome.GAIN.initial());
    }
}
