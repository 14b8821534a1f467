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
import lightning.base.text.Messages;
import lightning.editor.document.LightEdits;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.LightAttribute;
import lightning.scene.ShapeLinks;

/**
 * Drags a light onto a shape or a group, or one of these onto a light: the light ceases to shine on it, or shines on it again; with Ctrl and Shift
 * the same of the shadow that it throws in that light. The list of the others comes in front while its tab is under the mouse.
 */
final class LinkDrop {
    /** Where nothing is held, some systems say that a copy is made and some that a thing is moved: so both cannot be told apart. */
    private static final TransferMode[] MODES = {TransferMode.MOVE, TransferMode.LINK};
    static final DataFormat LIGHT = new DataFormat("application/x-lightning-light");
    private static final DataFormat SHAPE = new DataFormat("application/x-lightning-shape");
    private static final PseudoClass DROP_TARGET = PseudoClass.getPseudoClass("drop");

    private LinkDrop() {}

    /**
     * Lets what a line shows be dragged away.
     *
     * @param name of what the line shows; null where it shows nothing
     */
    static void makeDraggable(Cell<?> cell, DataFormat format, Supplier<String> name) {
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
    static void acceptShapes(LightCell cell, SceneEditor editor) {
        acceptDrops(cell, SHAPE, () -> cell.light() == null ? null : cell.light().name(),
                (shape, light, shadows) -> toggleLink(light, shape, shadows, editor));
    }

    /** The line of a shape or a group takes lights, and is dragged onto them. */
    static void installOnShape(Cell<?> cell, Supplier<String> name, SceneEditor editor) {
        makeDraggable(cell, SHAPE, name);
        acceptDrops(cell, LIGHT, name, (light, shape, shadows) -> toggleLink(light, shape, shadows, editor));
    }

    /** What is done with what was dragged and what it was dropped on. */
    private interface DropAction {
        void apply(String dragged, String target, boolean shadows);
    }

    private static void acceptDrops(Node cell, DataFormat format, Supplier<String> name, DropAction drop) {
        cell.addEventHandler(DragEvent.DRAG_OVER, event -> {
            if (event.getDragboard().hasContent(format) && name.get() != null) {
                event.acceptTransferModes(MODES);
                event.consume();
            }
        });
        cell.addEventHandler(DragEvent.DRAG_ENTERED_TARGET, event -> cell.pseudoClassStateChanged(DROP_TARGET,
                event.getDragboard().hasContent(format) && name.get() != null));
        cell.addEventHandler(DragEvent.DRAG_EXITED_TARGET, _ -> cell.pseudoClassStateChanged(DROP_TARGET, false));
        cell.addEventHandler(DragEvent.DRAG_DROPPED, event -> {
            if (event.getDragboard().getContent(format) instanceof String dragged && name.get() != null) {
                drop.apply(dragged, name.get(), event.getTransferMode() == TransferMode.LINK);
                event.setDropCompleted(true);
                event.consume();
            }
        });
    }

    /** The tab under the mouse comes in front, so that what is dragged from one list is dropped in another. */
    static void switchTabsOnDrag(TabPane tabs) {
        tabs.addEventFilter(DragEvent.DRAG_OVER, event -> tabs.getTabs().stream()
                .filter(tab -> tabs.lookup("#" + tab.getId()) instanceof Node header
                        && header.contains(header.sceneToLocal(event.getSceneX(), event.getSceneY())))
                .findFirst().ifPresent(tabs.getSelectionModel()::select));
    }

    /** @param shadows whether it is the shadow of the shape, and not the light on it */
    static void toggleLink(String light, String shape, boolean shadows, SceneEditor editor) {
        LightAttribute<ShapeLinks> attribute = shadows ? LightAttribute.SHADOWED_BY : LightAttribute.ILLUMINATES;
        if (editor.editOrReport(scene -> LightEdits.edit(scene, light, l -> attribute.with(l, toggle(attribute.get(l), shape))))
                .isEmpty()) {
            editor.scene().light(light).map(attribute::get).ifPresent(
                    links -> editor.message().show(message(light, shape, shadows, links.exclusive() == links.names().contains(shape))));
        }
    }

    private static ShapeLinks toggle(ShapeLinks links, String name) {
        return links.with(name, !links.names().contains(name));
    }

    private static String message(String light, String shape, boolean shadows, boolean linked) {
        if (shadows) {
            return linked ? Messages.tr("{0} casts shadows from {1}", shape, light)
                    : Messages.tr("{0} casts no shadows from {1}", shape, light);
        }
        return linked ? Messages.tr("{0} illuminates {1}", light, shape) : Messages.tr("{0} does not illuminate {1}", light, shape);
    }
}
