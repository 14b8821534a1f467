package lightning.editor.document;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import lightning.base.math.Rgb;
import lightning.base.text.Texts;
import lightning.scene.Bank;
import lightning.scene.Light;
import lightning.scene.Limits;
import lightning.scene.Rig;
import lightning.scene.Scene;

/** What one strip of the light mixer sets: a light, a bank of lights, or the environment. */
public sealed interface Channel {
    /** @param name of a light of the scene */
    record OfLight(String name) implements Channel {}

    /** @param name of a bank of the scene */
    record OfBank(String name) implements Channel {}

    /** The environment's light. */
    record OfEnvironment() implements Channel {}

    /** All channels: first the lights in no bank, then each bank and behind it its lights, in the scene's order; the environment last. */
    static List<Channel> all(Scene scene) {
        Rig rig = scene.rig();
        List<Channel> all = new ArrayList<>(members(rig, ""));
        for (Bank bank : rig.banks()) {
            all.add(new OfBank(bank.name()));
            all.addAll(members(rig, bank.name()));
        }
        if (scene.world().environment().isPresent()) {
            all.add(new OfEnvironment());
        }
        return all;
    }

    private static List<Channel> members(Rig rig, String bank) {
        return rig.lights().stream().filter(l -> l.bank().equals(bank)).<Channel>map(l -> new OfLight(l.name())).toList();
    }

    /** As people know it. */
    default String title() {
        return switch (this) {
            case OfLight(String name) -> name;
            case OfBank(String name) -> name;
            case OfEnvironment _ -> Texts.of("environment");
        };
    }

    /** Whether the scene has it. */
    default boolean isIn(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> scene.light(name).isPresent();
            case OfBank(String name) -> scene.rig().bank(name).isPresent();
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
            case OfBank(String name) -> BankEdits.bank(scene, name).intensity();
            case OfEnvironment _ -> scene.world().intensity();
        };
    }

    /** The largest intensity allowed. */
    default double most() {
        return switch (this) {
            case OfLight _ -> Limits.MAX_INTENSITY;
            case OfBank _ -> Limits.MAX_BANK_INTENSITY;
            case OfEnvironment _ -> Limits.MAX_BANK_INTENSITY;
        };
    }

    /** The scene with another intensity; throws as {@link #intensity}, and where it is out of range. */
    default Scene withIntensity(Scene scene, double v) {
        return switch (this) {
            case OfLight(String name) -> scene.withLight(LightEdits.light(scene, name).withIntensity(v));
            case OfBank(String name) -> scene.withRig(scene.rig().with(BankEdits.bank(scene, name).withIntensity(v)));
            case OfEnvironment _ -> scene.withWorld(scene.world().withIntensity(v));
        };
    }

    /** A light's colour or a bank's gel; the environment has none. */
    default Optional<Rgb> color(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> Optional.of(LightEdits.light(scene, name).color());
            case OfBank(String name) -> Optional.of(BankEdits.bank(scene, name).color());
            case OfEnvironment _ -> Optional.empty();
        };
    }

    /** The scene with another colour; the same where it has none. Throws as {@link #withIntensity}. */
    default Scene withColor(Scene scene, Rgb v) {
        return switch (this) {
            case OfLight(String name) -> scene.withLight(LightEdits.light(scene, name).withColor(v));
            case OfBank(String name) -> scene.withRig(scene.rig().with(BankEdits.bank(scene, name).withColor(v)));
            case OfEnvironment _ -> scene;
        };
    }

    /** Whether it is switched on; the environment always is. */
    default boolean isOn(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> LightEdits.light(scene, name).on();
            case OfBank(String name) -> BankEdits.bank(scene, name).on();
            case OfEnvironment _ -> true;
        };
    }

    /** The scene with it switched. */
    default Scene withOn(Scene scene, boolean v) {
        return switch (this) {
            case OfLight(String name) -> scene.withLight(LightEdits.light(scene, name).withOn(v));
            case OfBank(String name) -> scene.withRig(scene.rig().with(BankEdits.bank(scene, name).withOn(v)));
            case OfEnvironment _ -> scene;
        };
    }

    /** Whether it is solo; the environment never is. */
    default boolean isSolo(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> LightEdits.light(scene, name).solo();
            case OfBank(String name) -> BankEdits.bank(scene, name).solo();
            case OfEnvironment _ -> false;
        };
    }

    /** The scene with it solo, or not. */
    default Scene withSolo(Scene scene, boolean v) {
        return switch (this) {
            case OfLight(String name) -> scene.withLight(LightEdits.light(scene, name).withSolo(v));
            case OfBank(String name) -> scene.withRig(scene.rig().with(BankEdits.bank(scene, name).withSolo(v)));
            case OfEnvironment _ -> scene;
        };
    }

    /** Whether it adds to the picture: it is on, and no other's solo darkens it. */
    default boolean shines(Scene scene) {
        return switch (this) {
            case OfLight(String name) -> scene.shines(LightEdits.light(scene, name));
            case OfBank(String name) -> scene.lights().stream().anyMatch(l -> l.bank().equals(name) && scene.shines(l));
            case OfEnvironment _ -> scene.rig().actingLights().stream().noneMatch(l -> l.solo() && l.on());
        };
    }

    /** The places of its lights among those of the scene; none for the environment. */
    default int[] places(Scene scene) {
        List<Light> lights = scene.lights();
        return IntStream.range(0, lights.size()).filter(i -> switch (this) {
            case OfLight(String name) -> lights.get(i).name().equals(name);
            case OfBank(String name) -> lights.get(i).bank().equals(name);
            case OfEnvironment _ -> false;
        }).toArray();
    }
}
