package lightning.editor.window.property;

import javafx.css.PseudoClass;
import javafx.scene.input.DragEvent;
import javafx.scene.input.TransferMode;
import lightning.document.LightGroupEdits;
import lightning.editor.window.model.SceneEditor;

/** Drag and drop of lights in the list: onto a light group or one of its lights to join the group, elsewhere to leave it. */
final class LightGroupDrop {
    private static final PseudoClass DROP_TARGET = PseudoClass.getPseudoClass("drop");

    private LightGroupDrop() {}

    static void install(LightCell cell, SceneEditor editor) {
        LinkDrop.makeDraggable(cell, LinkDrop.LIGHT, () -> cell.light() == null ? null : cell.light().name());
        cell.setOnDragOver(event -> {
            if (event.getDragboard().hasContent(LinkDrop.LIGHT)) {
                event.acceptTransferModes(TransferMode.MOVE);
                event.consume();
            }
        });
        cell.setOnDragEntered(event -> cell.pseudoClassStateChanged(DROP_TARGET, event.getDragboard().hasContent(LinkDrop.LIGHT)));
        cell.setOnDragExited(_ -> cell.pseudoClassStateChanged(DROP_TARGET, false));
        cell.setOnDragDropped(event -> handleDrop(event, cell, editor));
    }

    private static void handleDrop(DragEvent event, LightCell target, SceneEditor editor) {
        if (event.getDragboard().getContent(LinkDrop.LIGHT) instanceof String light) {
            moveLight(light, target.groupName(), editor);
            event.setDropCompleted(true);
            event.consume();
        }
    }

    /** @param group  target light group; empty for none */
    static void moveLight(String light, String group, SceneEditor editor) {
        if (editor
                .editOrReport(
                        scene -> group.isEmpty() ? LightGroupEdits.removeLight(scene, light)
                                : LightGroupEdits.addLight(scene, light, group))
                .isEmpty()) {
            editor.selection().selectLight(light);
        }
    }
}
