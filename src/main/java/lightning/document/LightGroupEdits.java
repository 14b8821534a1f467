package lightning.document;

import java.util.function.UnaryOperator;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.scene.Scene;
import lightning.scene.light.LightGroup;

/** Edits of light groups. Each is refused if the named group or light does not exist. */
public final class LightGroupEdits {
    private LightGroupEdits() {}

    /** Edits one light group, keeping its name. */
    public static EditOutcome edit(Scene scene, String name, UnaryOperator<LightGroup> edit) {
        return EditOutcome.of(() -> scene.withRig(scene.rig().with(edit.apply(lightGroup(scene, name)))));
    }

    /**
     * Returns the light group with that name.
     *
     * @throws IllegalArgumentException if there is none
     */
    static LightGroup lightGroup(Scene scene, String name) {
        return scene.rig().lightGroup(name)
                .orElseThrow(() -> new RefusalException(Messages.tr("light group {0} not found", Quote.of(name))));
    }

    /** Moves a light to a group, out of its current one. */
    public static EditOutcome addLight(Scene scene, String light, String group) {
        return LightEdits.edit(scene, light, l -> l.withLightGroup(lightGroup(scene, group).name()));
    }

    /** Removes a light from its group. */
    public static EditOutcome removeLight(Scene scene, String light) {
        return LightEdits.edit(scene, light, l -> l.withLightGroup(""));
    }

    /** Moves a light to a new group with a unique name. */
    public static EditOutcome create(Scene scene, String light) {
        return EditOutcome.of(() -> {
            LightGroup group = LightGroup.of(LightEdits.freeName(scene, "group"));
            Scene extended = scene.withRig(scene.rig().addLightGroup(group));
            return extended.withLight(LightEdits.light(scene, light).withLightGroup(group.name()));
        });
    }

    /** Renames a group and updates its lights. Refused if the name is taken or invalid in a scene file. */
    public static EditOutcome rename(Scene scene, String name, String newName) {
        return EditOutcome.of(() -> scene.withRig(scene.rig().renameLightGroup(name, newName)));
    }

    /** Deletes a group; its lights stay, without a group. */
    public static EditOutcome delete(Scene scene, String name) {
        return EditOutcome.of(() -> scene.withRig(scene.rig().removeLightGroup(name)));
    }
}
