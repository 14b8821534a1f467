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
import lightning.document.LightEdits;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.light.LightAttribute;
import lightning.scene.value.ShapeLinks;

/**
 * Drag and drop for light linking. Dropping a light on a shape or group, or the other way around, toggles illumination; with Ctrl+Shift it
 * toggles the shadow.
 *
 * <p>Dragging over a tab selects it.
 */
final class LinkDrop {
    /** Without modifiers, some systems report copy and others move. Link is used for Ctrl+Shift, so that both are distinguishable. */
    private static final TransferMode[] MODES = {TransferMode.MOVE, TransferMode.LINK};
    static final DataFormat LIGHT = new DataFormat("application/x-lightning-light");
    private static final DataFormat SHAPE = new DataFormat("application/x-lightning-shape");
    private static final PseudoClass DROP_TARGET = PseudoClass.getPseudoClass("drop");

    private LinkDrop() {}

    /**
     * Makes a cell's item draggable.
     *
     * @param name  name of the item; null if the cell is empty
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

    /** Lets the cell of a light accept shapes and groups. */
    static void acceptShapes(LightCell cell, SceneEditor editor) {
        acceptDrops(cell, SHAPE, () -> cell.light() == null ? null : cell.light().name(),
                (shape, light, shadows) -> toggleLink(light, shape, shadows, editor));
    }

    /** Lets the cell of a shape or group accept lights and be dragged onto lights. */
    static void installOnShape(Cell<?> cell, Supplier<String> name, SceneEditor editor) {
        makeDraggable(cell, SHAPE, name);
        acceptDrops(cell, LIGHT, name, (light, shape, shadows) -> toggleLink(light, shape, shadows, editor));
    }

    /** Action for a dragged item and its drop target. */
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

    /** Selects the tab under the mouse during a drag, so that items can be dropped in another list. */
    static void switchTabsOnDrag(TabPane tabs) {
        tabs.addEventFilter(DragEvent.DRAG_OVER, event -> tabs.getTabs().stream()
                .filter(tab -> tabs.lookup("#" + tab.getId()) instanceof Node header
                        && header.contains(header.sceneToLocal(event.getSceneX(), event.getSceneY())))
                .findFirst().ifPresent(tabs.getSelectionModel()::select));
    }

    /** @param shadows  true to toggle the shape's shadow, false its illumination */
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
