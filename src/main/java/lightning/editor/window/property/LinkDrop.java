package lightning.editor.window.property;

import java.util.function.Supplier;
import javafx.css.PseudoClass;
import javafx.scene.Node;
import javafx.scene.control.Cell;
import javafx.scene.control.TabPane;
import javafx.scene.input.ClipboardContent;
import javafx.scene.input.DataFormat;
import javafx.scene.input.DragEvent;
import javafx.scene.input.Dragboard;
import javafx.scene.input.TransferMode;
import lightning.base.text.Texts;
import lightning.editor.document.LightEdits;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.LightAttribute;
import lightning.scene.Links;

/**
 * Drags a light onto a shape or a group, or one of these onto a light: the light ceases to shine on it, or shines on it again; with Ctrl and Shift
 * the same of the shadow that it throws in that light. The list of the others comes in front while its tab is under the mouse.
 */
final class LinkDrop {
    /** Where nothing is held, some systems say that a copy is made and some that a thing is moved: so both cannot be told apart. */
    private static final TransferMode[] MODES = {TransferMode.MOVE, TransferMode.LINK};
    static final DataFormat LIGHT = new DataFormat("application/x-lightning-light");
    private static final DataFormat SHAPE = new DataFormat("application/x-lightning-shape");
    private static final PseudoClass OVER = PseudoClass.getPseudoClass("drop");

    private LinkDrop() {}

    /**
     * Lets what a line shows be dragged away.
     *
     * @param name of what the line shows; null where it shows nothing
     */
    static void drag(Cell<?> cell, DataFormat format, Supplier<String> name) {
        cell.setOnDragDetected(event -> {
            if (name.get() != null && !cell.isEditing()) {
                Dragboard board = cell.startDragAndDrop(MODES);
                var content = new ClipboardContent();
                content.put(format, name.get());
                board.setContent(content);
                event.consume();
            }
        });
    }

    /** A light's line takes shapes and groups. */
    static void ontoLight(LightCell cell, SceneEditor editor) {
        takes(cell, SHAPE, () -> cell.light() == null ? null : cell.light().name(),
                (shape, light, shadows) -> drop(light, shape, shadows, editor));
    }

    /** The line of a shape or a group takes lights, and is dragged onto them. */
    static void ofShape(Cell<?> cell, Supplier<String> name, SceneEditor editor) {
        drag(cell, SHAPE, name);
        takes(cell, LIGHT, name, (light, shape, shadows) -> drop(light, shape, shadows, editor));
    }

    /** What is done with what was dragged and what it was dropped on. */
    private interface Drop {
        void done(String dragged, String on, boolean shadows);
    }

    private static void takes(Node cell, DataFormat format, Supplier<String> name, Drop drop) {
        cell.addEventHandler(DragEvent.DRAG_OVER, event -> {
            if (event.getDragboard().hasContent(format) && name.get() != null) {
                event.acceptTransferModes(MODES);
                event.consume();
            }
        });
        cell.addEventHandler(DragEvent.DRAG_ENTERED_TARGET, event -> cell.pseudoClassStateChanged(OVER,
                event.getDragboard().hasContent(format) && name.get() != null));
        cell.addEventHandler(DragEvent.DRAG_EXITED_TARGET, _ -> cell.pseudoClassStateChanged(OVER, false));
        cell.addEventHandler(DragEvent.DRAG_DROPPED, event -> {
            if (event.getDragboard().getContent(format) instanceof String dragged && name.get() != null) {
                drop.done(dragged, name.get(), event.getTransferMode() == TransferMode.LINK);
                event.setDropCompleted(true);
                event.consume();
            }
        });
    }

    /** The tab under the mouse comes in front, so that what is dragged from one list is dropped in another. */
    static void throughTabs(TabPane tabs) {
        tabs.addEventFilter(DragEvent.DRAG_OVER, event -> tabs.getTabs().stream()
                .filter(tab -> tabs.lookup("#" + tab.getId()) instanceof Node header
                        && header.contains(header.sceneToLocal(event.getSceneX(), event.getSceneY())))
                .findFirst().ifPresent(tabs.getSelectionModel()::select));
    }

    /** @param shadows whether it is the shadow of the shape, and not the light on it */
    static void drop(String light, String shape, boolean shadows, SceneEditor editor) {
        LightAttribute<Links> attribute = shadows ? LightAttribute.SHADOWED_BY : LightAttribute.ILLUMINATES;
        if (editor.editOrReport(scene -> LightEdits.with(scene, light, l -> attribute.with(l, flipped(attribute.of(l), shape))))
                .isEmpty()) {
            editor.scene().light(light).map(attribute::of).ifPresent(
                    links -> editor.message().show(told(light, shape, shadows, links.only() == links.names().contains(shape))));
        }
    }

    private static Links flipped(Links links, String name) {
        return links.with(name, !links.names().contains(name));
    }

    private static String told(String light, String shape, boolean shadows, boolean linked) {
        if (shadows) {
            return linked ? Texts.of("{0} throws a shadow in the light of {1}", shape, light)
                    : Texts.of("{0} throws no shadow in the light of {1}", shape, light);
        }
        return linked ? Texts.of("{0} shines on {1}", light, shape) : Texts.of("{0} does not shine on {1}", light, shape);
    }
}
