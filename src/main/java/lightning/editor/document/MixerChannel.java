package lightning.editor.document;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import lightning.base.math.Rgb;
import lightning.base.text.Messages;
import lightning.scene.Light;
import lightning.scene.LightGroup;
import lightning.scene.LightRig;
import lightning.scene.Scene;
import lightning.scene.SceneLimits;

/** What one strip of the light mixer sets: a light, a bank of lights, or the environment. */
public sealed interface MixerChannel {
    /** @param name of a light of the scene */
    record OfLight(String name) implements MixerChannel {}

    /** @param name of a bank of the scene */
    record OfLightGroup(String name) implements MixerChannel {}

    /** The environment's light. */
    record OfEnvironment() implements MixerChannel {}

    /** All channels: first the lights in no bank, then each bank and behind it its lights, in the scene's order; the environment last. */
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
        return all;
    }

    private static List<MixerChannel> members(LightRig rig, String group) {
        return rig.lights().stream().filter(l -> l.lightGroup().equals(group)).<MixerChannel>map(l -> new OfLight(l.name())).toList();
    }

    /** As people know it. */
    default String title() {
        return switch (this) {
            case OfLight(String name) -> name;
            case OfLightGroup(String name) -> name;
            case OfEnvironment _ -> Messages.tr("environment");
        };
    }

    /** Whether the scene has it. */
    default boolean isIn(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> scene.light(name).isPresent();
            case OfLightGroup(String name) -> scene.rig().lightGroup(name).isPresent();
            case OfEnvironment _ -> scene.world().environment().isPresent();
        };
    }

    /**
     * What the fader sets: a light's own intensity, a bank's master, the environment's factor.
     *
     * @throws IllegalArgumentException if the scene has no such light or bank
     */
    default double intensity(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> LightEdits.light(scene, name).intensity();
            case OfLightGroup(String name) -> LightGroupEdits.lightGroup(scene, name).intensity();
            case OfEnvironment _ -> scene.world().intensity();
        };
    }

    /** The largest intensity allowed. */
    default double maxIntensity() {
        return switch (this) {
            case OfLight _ -> SceneLimits.MAX_INTENSITY;
            case OfLightGroup _ -> SceneLimits.MAX_GROUP_INTENSITY;
            case OfEnvironment _ -> SceneLimits.MAX_GROUP_INTENSITY;
        };
    }

    /** The scene with another intensity; throws as {@link #intensity}, and where it is out of range. */
    default Scene withIntensity(Scene scene, double v) {
        return switch (this) {
            case OfLight(String name) -> scene.withLight(LightEdits.light(scene, name).withIntensity(v));
            case OfLightGroup(String name) -> scene.withRig(scene.rig().with(LightGroupEdits.lightGroup(scene, name).withIntensity(v)));
            case OfEnvironment _ -> scene.withWorld(scene.world().withIntensity(v));
        };
    }

    /** A light's color or a bank's gel; the environment has none. */
    default Optional<Rgb> color(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> Optional.of(LightEdits.light(scene, name).color());
            case OfLightGroup(String name) -> Optional.of(LightGroupEdits.lightGroup(scene, name).color());
            case OfEnvironment _ -> Optional.empty();
        };
    }

    /** The scene with another color; the same where it has none. Throws as {@link #withIntensity}. */
    default Scene withColor(Scene scene, Rgb v) {
        return switch (this) {
            case OfLight(String name) -> scene.withLight(LightEdits.light(scene, name).withColor(v));
            case OfLightGroup(String name) -> scene.withRig(scene.rig().with(LightGroupEdits.lightGroup(scene, name).withColor(v)));
            case OfEnvironment _ -> scene;
        };
    }

    /** Whether it is switched on; the environment always is. */
    default boolean isOn(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> LightEdits.light(scene, name).on();
            case OfLightGroup(String name) -> LightGroupEdits.lightGroup(scene, name).on();
            case OfEnvironment _ -> true;
        };
    }

    /** The scene with it switched. */
    default Scene withOn(Scene scene, boolean v) {
        return switch (this) {
            case OfLight(String name) -> scene.withLight(LightEdits.light(scene, name).withOn(v));
            case OfLightGroup(String name) -> scene.withRig(scene.rig().with(LightGroupEdits.lightGroup(scene, name).withOn(v)));
            case OfEnvironment _ -> scene;
        };
    }

    /** Whether it is solo; the environment never is. */
    default boolean isSolo(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> LightEdits.light(scene, name).solo();
            case OfLightGroup(String name) -> LightGroupEdits.lightGroup(scene, name).solo();
            case OfEnvironment _ -> false;
        };
    }

    /** The scene with it solo, or not. */
    default Scene withSolo(Scene scene, boolean v) {
        return switch (this) {
            case OfLight(String name) -> scene.withLight(LightEdits.light(scene, name).withSolo(v));
            case OfLightGroup(String name) -> scene.withRig(scene.rig().with(LightGroupEdits.lightGroup(scene, name).withSolo(v)));
            case OfEnvironment _ -> scene;
        };
    }

    /** Whether it adds to the picture: it is on, and no other's solo darkens it. */
    default boolean isShining(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> scene.isActive(LightEdits.light(scene, name));
            case OfLightGroup(String name) -> scene.lights().stream().anyMatch(l -> l.lightGroup().equals(name) && scene.isActive(l));
            case OfEnvironment _ -> scene.rig().effectiveLights().stream().noneMatch(l -> l.solo() && l.on());
        };
    }

    /** The places of its lights among those of the scene; none for the environment. */
    default int[] lightIndices(Scene scene) {
        List<Light> lights = scene.lights();
        return IntStream.range(0, lights.size()).filter(i -> switch (this) {
            case OfLight(String name) -> lights.get(i).name().equals(name);
            case OfLightGroup(String name) -> lights.get(i).lightGroup().equals(name);
            case OfEnvironment _ -> false;
        }).toArray();
    }
}
