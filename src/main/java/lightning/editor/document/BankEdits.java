package lightning.editor.document;

import java.util.function.UnaryOperator;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.scene.Bank;
import lightning.scene.Scene;

/** The edits of banks of lights. Each is refused if there is no bank, or no light, of the name given. */
public final class BankEdits {
    private BankEdits() {}

    /** Any edit of one bank that keeps its name. */
    public static Change with(Scene scene, String name, UnaryOperator<Bank> edit) {
        return Change.of(() -> scene.withRig(scene.rig().with(edit.apply(bank(scene, name)))));
    }

    /**
     * The bank of that name.
     *
     * @throws IllegalArgumentException if there is none
     */
    static Bank bank(Scene scene, String name) {
        return scene.rig().bank(name).orElseThrow(() -> new IllegalArgumentException(Texts.of("there is no bank {0}", Quote.of(name))));
    }

    /** Puts a light into a bank, out of the one that it was in. */
    public static Change join(Scene scene, String light, String bank) {
        return LightEdits.with(scene, light, l -> l.withBank(bank(scene, bank).name()));
    }

    /** Takes a light out of its bank. */
    public static Change leave(Scene scene, String light) {
        return LightEdits.with(scene, light, l -> l.withBank(""));
    }

    /** Puts a light into a bank of its own, with a free name. */
    public static Change add(Scene scene, String light) {
        return Change.of(() -> {
            Bank bank = Bank.of(LightEdits.freeName(scene, "bank"));
            Scene more = scene.withRig(scene.rig().plus(bank));
            return more.withLight(LightEdits.light(scene, light).withBank(bank.name()));
        });
    }

    /** Another name; its lights follow. Refused if the name is taken or could not stand in a scene file. */
    public static Change rename(Scene scene, String name, String newName) {
        return Change.of(() -> scene.withRig(scene.rig().renamed(name, newName)));
    }

    /** Takes a bank away; its lights stay, in none. */
    public static Change delete(Scene scene, String name) {
        return Change.of(() -> scene.withRig(scene.rig().without(name)));
    }
}
