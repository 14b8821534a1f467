package lightning.editor.document;

import java.util.function.UnaryOperator;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.scene.LightGroup;
import lightning.scene.Scene;

/** The edits of banks of lights. Each is refused if there is no bank, or no light, of the name given. */
public final class LightGroupEdits {
    private LightGroupEdits() {}

    /** Any edit of one bank that keeps its name. */
    public static EditOutcome edit(Scene scene, String name, UnaryOperator<LightGroup> edit) {
        return EditOutcome.of(() -> scene.withRig(scene.rig().with(edit.apply(lightGroup(scene, name)))));
    }

    /**
     * The bank of that name.
     *
     * @throws IllegalArgumentException if there is none
     */
    static LightGroup lightGroup(Scene scene, String name) {
        return scene.rig().lightGroup(name)
                .orElseThrow(() -> new IllegalArgumentException(Messages.tr("light group {0} not found", Quote.of(name))));
    }

    /** Puts a light into a bank, out of the one that it was in. */
    public static EditOutcome addLight(Scene scene, String light, String group) {
        return LightEdits.edit(scene, light, l -> l.withLightGroup(lightGroup(scene, group).name()));
    }

    /** Takes a light out of its bank. */
    public static EditOutcome removeLight(Scene scene, String light) {
        return LightEdits.edit(scene, light, l -> l.withLightGroup(""));
    }

    /** Puts a light into a bank of its own, with a free name. */
    public static EditOutcome create(Scene scene, String light) {
        return EditOutcome.of(() -> {
            LightGroup group = LightGroup.of(LightEdits.freeName(scene, "bank"));
            Scene extended = scene.withRig(scene.rig().addLightGroup(group));
            return extended.withLight(LightEdits.light(scene, light).withLightGroup(group.name()));
        });
    }

    /** Another name; its lights follow. Refused if the name is taken or could not stand in a scene file. */
    public static EditOutcome rename(Scene scene, String name, String newName) {
        return EditOutcome.of(() -> scene.withRig(scene.rig().renameLightGroup(name, newName)));
    }

    /** Takes a bank away; its lights stay, in none. */
    public static EditOutcome delete(Scene scene, String name) {
        return EditOutcome.of(() -> scene.withRig(scene.rig().removeLightGroup(name)));
    }
}
