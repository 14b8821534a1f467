package lightning.editor.window.property;

import javafx.css.PseudoClass;
import javafx.scene.input.DragEvent;
import javafx.scene.input.TransferMode;
import lightning.editor.document.BankEdits;
import lightning.editor.window.model.SceneEditor;

/** Drags a light from its line to that of a bank or of a light in one, which it joins; anywhere else it leaves its bank. */
final class BankDrop {
    private static final PseudoClass OVER = PseudoClass.getPseudoClass("drop");

    private BankDrop() {}

    static void between(LightCell cell, SceneEditor editor) {
        LinkDrop.drag(cell, LinkDrop.LIGHT, () -> cell.light() == null ? null : cell.light().name());
        cell.setOnDragOver(event -> {
            if (event.getDragboard().hasContent(LinkDrop.LIGHT)) {
                event.acceptTransferModes(TransferMode.MOVE);
                event.consume();
            }
        });
        cell.setOnDragEntered(event -> cell.pseudoClassStateChanged(OVER, event.getDragboard().hasContent(LinkDrop.LIGHT)));
        cell.setOnDragExited(_ -> cell.pseudoClassStateChanged(OVER, false));
        cell.setOnDragDropped(event -> drop(event, cell, editor));
    }

    private static void drop(DragEvent event, LightCell on, SceneEditor editor) {
        if (event.getDragboard().getContent(LinkDrop.LIGHT) instanceof String light) {
            drop(light, on.bank(), editor);
            event.setDropCompleted(true);
            event.consume();
        }
    }

    /** @param bank where it is dropped; empty for none */
    static void drop(String light, String bank, SceneEditor editor) {
        if (editor.editOrReport(scene -> bank.isEmpty() ? BankEdits.leave(scene, light) : BankEdits.join(scene, light, bank)).isEmpty()) {
            editor.selection().selectLight(light);
        }
    }
}
