package lightning.editor.document;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import lightning.base.math.Rgb;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.scene.Dome;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightRig;
import lightning.scene.value.SceneLimits;

/** Channel of the light mixer: a light, a light group, the environment, or a dome. */
public sealed interface MixerChannel {
    /** @param name name of a light of the scene */
    record OfLight(String name) implements MixerChannel {}

    /** @param name name of a light group of the scene */
    record OfLightGroup(String name) implements MixerChannel {}

    /** Channel of the world's own environment. */
    record OfEnvironment() implements MixerChannel {}

    /** @param name name of a dome of the scene */
    record OfDome(String name) implements MixerChannel {}

    /**
     * Returns all channels in the order of the scene: lights without a group, then each group followed by its lights, then the environment
     * and the domes.
     */
    static List<MixerChannel> channelsOf(Scene scene) {
        LightRig rig = scene.rig();
        List<MixerChannel> all = new ArrayList<>(members(rig, ""));
        for (LightGroup bank : rig.lightGroups()) {
            all.add(new OfLightGroup(bank.name()));
            all.addAll(members(rig, bank.name()));
        }
        if (scene.world().environment().isPresent()) {
            all.add(new OfEnvironment());
        }
        scene.world().domes().forEach(dome -> all.add(new OfDome(dome.name())));
        return all;
    }

    private static List<MixerChannel> members(LightRig rig, String group) {
        return rig.lights().stream().filter(l -> l.lightGroup().equals(group)).<MixerChannel>map(l -> new OfLight(l.name())).toList();
    }

    /** Returns the title for people. */
    default String title() {
        return switch (this) {
            case OfLight(String name) -> name;
            case OfLightGroup(String name) -> name;
            case OfEnvironment _ -> Messages.tr("environment");
            case OfDome(String name) -> name;
        };
    }

    /** Returns whether the scene has this channel. */
    default boolean isIn(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> scene.light(name).isPresent();
            case OfLightGroup(String name) -> scene.rig().lightGroup(name).isPresent();
            case OfEnvironment _ -> scene.world().environment().isPresent();
            case OfDome(String name) -> scene.world().dome(name).isPresent();
        };
    }

    /**
     * Returns the fader's value: a light's own intensity, a group's master, or the factor of the environment or a dome.
     *
     * @throws IllegalArgumentException if the scene has no such light or group
     */
    default double intensity(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> LightEdits.light(scene, name).intensity();
            case OfLightGroup(String name) -> LightGroupEdits.lightGroup(scene, name).intensity();
            case OfEnvironment _ -> scene.world().intensity();
            case OfDome(String name) -> dome(scene, name).intensity();
        };
    }

    /** Returns the maximum intensity. */
    default double maxIntensity() {
        return switch (this) {
            case OfLight _ -> SceneLimits.MAX_INTENSITY;
            case OfLightGroup _ -> SceneLimits.MAX_GROUP_INTENSITY;
            case OfEnvironment _ -> SceneLimits.MAX_GROUP_INTENSITY;
            case OfDome _ -> SceneLimits.MAX_GROUP_INTENSITY;
        };
    }

    /** Returns the scene with another intensity; throws as {@link #intensity}, and if it is out of range. */
    default Scene withIntensity(Scene scene, double v) {
        return switch (this) {
            case OfLight(String name) -> scene.withLight(LightEdits.light(scene, name).withIntensity(v));
            case OfLightGroup(String name) -> scene.withRig(scene.rig().with(LightGroupEdits.lightGroup(scene, name).withIntensity(v)));
            case OfEnvironment _ -> scene.withWorld(scene.world().withIntensity(v));
            case OfDome(String name) -> edit(scene, name, d -> d.withIntensity(v));
        };
    }

    /** Returns a light's color or a group's gel; empty for the environment and domes. */
    default Optional<Rgb> color(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> Optional.of(LightEdits.light(scene, name).color());
            case OfLightGroup(String name) -> Optional.of(LightGroupEdits.lightGroup(scene, name).color());
            case OfEnvironment _ -> Optional.empty();
            case OfDome _ -> Optional.empty();
        };
    }

    /** Returns the scene with another color; unchanged for the environment and domes. Throws as {@link #withIntensity}. */
    default Scene withColor(Scene scene, Rgb v) {
        return switch (this) {
            case OfLight(String name) -> scene.withLight(LightEdits.light(scene, name).withColor(v));
            case OfLightGroup(String name) -> scene.withRig(scene.rig().with(LightGroupEdits.lightGroup(scene, name).withColor(v)));
            case OfEnvironment _ -> scene;
            case OfDome _ -> scene;
        };
    }

    /** Returns whether the channel can be moved to another place of the mixer. */
    default boolean canBeMoved() {
        return this instanceof OfLight || this instanceof OfLightGroup;
    }

    /** Returns a light's color temperature in kelvin; empty for other channels. */
    default Optional<Double> temperature(Scene scene) {
        return this instanceof OfLight(String name) ? Optional.of(LightEdits.light(scene, name).emission().temperature())
                : Optional.empty();
    }

    /** Returns the scene with another color temperature of a light; unchanged for other channels. Throws as {@link #withIntensity}. */
    default Scene withTemperature(Scene scene, double kelvin) {
        return this instanceof OfLight(String name)
                ? scene.withLight(LightAttribute.TEMPERATURE.with(LightEdits.light(scene, name), kelvin)) : scene;
    }

    /** Returns whether the channel is on; the environment is unless its light is dark. */
    default boolean isOn(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> LightEdits.light(scene, name).on();
            case OfLightGroup(String name) -> LightGroupEdits.lightGroup(scene, name).on();
            case OfEnvironment _ -> scene.world().lightIntensity() > 0;
            case OfDome(String name) -> dome(scene, name).on();
        };
    }

    /**
     * Returns the scene with the channel on or off. A muted environment has a light gain of 0, which leaves its image;
     * a muted dome is off.
     */
    default Scene withOn(Scene scene, boolean v) {
        return switch (this) {
            case OfLight(String name) -> scene.withLight(LightEdits.light(scene, name).withOn(v));
            case OfLightGroup(String name) -> scene.withRig(scene.rig().with(LightGroupEdits.lightGroup(scene, name).withOn(v)));
            case OfEnvironment _ -> isOn(scene) == v ? scene : scene.withWorld(v ? litWorld(scene.world()) : scene.world().withGain(0));
            case OfDome(String name) -> edit(scene, name, d -> d.withOn(v));
        };
    }

    /** Returns a dark world with a light intensity above 0. Files of earlier versions muted the environment with its intensity. */
    private static World litWorld(World world) {
        return world.withIntensity(world.intensity() > 0 ? world.intensity() : World.INTENSITY.initial())
                .withGain(world.gain() > 0 ? world.gain() : World.GAIN.initial());
    }

    /** Returns whether the channel is solo. */
    default boolean isSolo(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> LightEdits.light(scene, name).solo();
            case OfLightGroup(String name) -> LightGroupEdits.lightGroup(scene, name).solo();
            case OfEnvironment _ -> scene.world().solo();
            case OfDome(String name) -> dome(scene, name).solo();
        };
    }

    /** Returns the scene with the channel's solo on or off. */
    default Scene withSolo(Scene scene, boolean v) {
        return switch (this) {
            case OfLight(String name) -> scene.withLight(LightEdits.light(scene, name).withSolo(v));
            case OfLightGroup(String name) -> scene.withRig(scene.rig().with(LightGroupEdits.lightGroup(scene, name).withSolo(v)));
            case OfEnvironment _ -> scene.withWorld(scene.world().withSolo(v));
            case OfDome(String name) -> edit(scene, name, d -> d.withSolo(v));
        };
    }

    /** Returns whether the channel contributes to the image: it is on and not muted by another's solo. */
    default boolean isShining(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> scene.isActive(LightEdits.light(scene, name));
            case OfLightGroup(String name) -> scene.lights().stream().anyMatch(l -> l.lightGroup().equals(name) && scene.isActive(l));
            case OfEnvironment _ ->
                    isOn(scene) && (scene.world().solo() || scene.rig().effectiveLights().stream().noneMatch(l -> l.solo() && l.on()));
            case OfDome(String name) -> dome(scene, name).lightIntensity() > 0 && scene.rig().isEnvironmentActive(environmentIndex(scene));
        };
    }

    /** Returns the indices of the channel's lights in the scene; none for the environment and domes. */
    default int[] lightIndices(Scene scene) {
        List<Light> lights = scene.lights();
        return IntStream.range(0, lights.size()).filter(i -> switch (this) {
            case OfLight(String name) -> lights.get(i).name().equals(name);
            case OfLightGroup(String name) -> lights.get(i).lightGroup().equals(name);
            case OfEnvironment _ -> false;
            case OfDome _ -> false;
        }).toArray();
    }

    /** Returns the number among the scene's environments of the environment or a dome; −1 for other channels, and for a dome without an image. */
    default int environmentIndex(Scene scene) {
        return switch (this) {
            case OfLight _,OfLightGroup _ -> -1;
            case OfEnvironment _ -> 0;
            case OfDome(String name) -> scene.world().environmentIndex(name);
        };
    }

    private static Dome dome(Scene scene, String name) {
        return scene.world().dome(name).orElseThrow(() -> new IllegalArgumentException("there is no dome " + Quote.of(name)));
    }

    private static Scene edit(Scene scene, String name, UnaryOperator<Dome> change) {
        return scene.withWorld(scene.world().withDome(name, change.apply(dome(scene, name))));
    }
}
