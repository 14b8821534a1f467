package lightning.editor.window.model;

import lightning.editor.document.Command;
import lightning.editor.document.NodeEdits;
import lightning.scene.Node;

/** What the commands do to the selected shape or group. */
final class NodeActions {
    private NodeActions() {}

    static void addTo(EditorModel model) {
        model.commands().setAction(Command.SHOW_SHAPE, () -> model.selectedNode()
                .ifPresent(n -> model.edit(scene -> NodeEdits.visible(scene, n.name(), !n.visible())).ifPresent(model::say)));
        model.commands().setAction(Command.DUPLICATE_SHAPE, () -> model.selectedNode().ifPresent(n -> duplicate(model, n)));
        model.commands().setAction(Command.DELETE_SHAPE, () -> model.selectedNode()
                .ifPresent(n -> model.edit(scene -> NodeEdits.delete(scene, n.name())).ifPresent(model::say)));
    }

    /** The copy is selected. */
    private static void duplicate(EditorModel model, Node original) {
        String copy = NodeEdits.copyOf(model.scene(), original.name());
        model.editAndSelect(scene -> NodeEdits.duplicate(scene, original.name()), copy).ifPresentOrElse(model::say,
                () -> LightActions.tellBeside(model, copy, original.name()));
    }
}
