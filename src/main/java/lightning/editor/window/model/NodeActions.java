package lightning.editor.window.model;

import lightning.document.EditOutcome;
import lightning.document.NewBlocker;
import lightning.document.NodeEdits;
import lightning.editor.Command;
import lightning.scene.ObjectLight;
import lightning.scene.node.SceneNode;

/** Actions of the commands for the selected shape or group. */
final class NodeActions {
    private NodeActions() {}

    static void register(SceneEditor editor, CommandRegistry commands) {
        commands.setAction(Command.SHOW_SHAPE, () -> editor.selection().node()
                .ifPresent(n -> editor.editOrReport(scene -> NodeEdits.setVisible(scene, n.name(), !n.visible()))));
        commands.setAction(Command.DUPLICATE_SHAPE, () -> editor.selection().node().ifPresent(n -> duplicate(editor, n)));
        commands.setAction(Command.MAKE_LIGHT, () -> editor.selection().node().ifPresent(n -> makeLight(editor, n.name())));
        commands.setAction(Command.LIGHTS_OF_GLOW, () -> editor.editOrReport(scene -> EditOutcome.of(() -> ObjectLight.makeAll(scene))));
        commands.setAction(Command.ADD_BLOCKER, () -> addBlocker(editor));
        commands.setAction(Command.DELETE_SHAPE, () -> editor.selection().node()
                .ifPresent(n -> editor.editOrReport(scene -> NodeEdits.delete(scene, n.name()))));
    }

    /** Makes a shape a light and selects it. */
    static void makeLight(SceneEditor editor, String shape) {
        String light = ObjectLight.lightName(editor.scene(), shape);
        if (editor.editOrReport(scene -> NodeEdits.makeLight(scene, shape, light)).isEmpty()) {
            editor.selection().selectLight(light);
        }
    }

    /** Adds a blocker before the selected light and selects it. */
    private static void addBlocker(SceneEditor editor) {
        String light = editor.selection().lightName();
        editor.editAndSelect(scene -> NewBlocker.add(scene, light), NewBlocker.name(editor.scene()));
    }

    /** Duplicates a shape or group and selects the copy. */
    private static void duplicate(SceneEditor editor, SceneNode original) {
        String copy = NodeEdits.copyName(editor.scene(), original.name());
        if (editor.editAndSelect(scene -> NodeEdits.duplicate(scene, original.name()), copy).isEmpty()) {
            LightActions.reportDuplicateOffset(editor, copy, original.name());
        }
    }
}
