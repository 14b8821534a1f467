package lightning.editor.window.command;

import java.util.function.BiConsumer;
import java.util.function.Supplier;
import javafx.scene.Node;
import javafx.scene.image.Image;
import javafx.scene.input.ClipboardContent;
import javafx.scene.input.DataFormat;
import javafx.scene.input.DragEvent;
import javafx.scene.input.Dragboard;
import javafx.scene.input.TransferMode;
import lightning.base.text.Messages;
import lightning.document.MaterialEdits;
import lightning.document.MaterialLibrary;
import lightning.editor.window.model.MaterialSelection;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/** Drag and drop of materials of the library onto objects. */
public final class MaterialDrop {
    private static final DataFormat MATERIAL = new DataFormat("application/x-lightning-material");
    /** Without modifiers, some systems report copy and others move. */
    private static final TransferMode[] MODES = TransferMode.COPY_OR_MOVE;

    private MaterialDrop() {}

    /**
     * Makes a node a material that can be dragged.
     *
     * @param picture returns the image under the mouse during the drag; null for none
     */
    public static void makeDraggable(Node node, Material material, Supplier<@Nullable Image> picture) {
        node.setOnDragDetected(event -> {
            Dragboard board = node.startDragAndDrop(MODES);
            var content = new ClipboardContent();
            content.put(MATERIAL, material.name());
            board.setContent(content);
            Image image = picture.get();
            if (image != null) {
                board.setDragView(image, image.getWidth() / 2, image.getHeight() / 2);
            }
            event.consume();
        });
    }

    /**
     * Lets a node accept materials.
     *
     * @param onDrop receives the material, and the drop with its position in the node
     */
    public static void accept(Node target, BiConsumer<Material, DragEvent> onDrop) {
        target.addEventHandler(DragEvent.DRAG_OVER, event -> {
            if (event.getDragboard().hasContent(MATERIAL)) {
                event.acceptTransferModes(MODES);
                event.consume();
            }
        });
        target.addEventHandler(DragEvent.DRAG_DROPPED, event -> {
            if (event.getDragboard().getContent(MATERIAL) instanceof String name) {
                MaterialLibrary.find(name).ifPresent(material -> onDrop.accept(material, event));
                event.setDropCompleted(true);
                event.consume();
            }
        });
    }

    /** Gives a material to a shape, or to all shapes in a group, and says so in the status line. */
    public static void apply(SceneEditor editor, MaterialSelection materials, String node, Material material) {
        if (editor.editOrReport(scene -> MaterialLibrary.apply(scene, node, material)).isEmpty()) {
            MaterialEdits.ofShape(editor.scene(), node).ifPresent(m -> materials.choose(m.name()));
            editor.message().show(Messages.tr("{0} has the material {1}", node, Messages.tr(material.name())));
        }
    }
}
