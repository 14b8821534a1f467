package lightning.editor.window.property;

import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.editor.Command;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.model.EditorModel;
import lightning.scene.SceneElement;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;

/** Property editor of the selected shape's or group's placement: position, rotation and scale. */
final class NodePane extends AttributeForm<SceneNode> {
    private final Label name = new Label();
    private final Label summary = new Label();

    /**
     * @param menu  context menu of the properties
     * @param tabSelected  true while the pane is visible; it is updated only then
     */
    NodePane(EditorModel model, PropertyMenu menu, ObservableValue<Boolean> tabSelected) {
        super(model, menu);
        setId("shape");
        getStyleClass().add("properties");
        name.setId("shape-name");
        name.getStyleClass().add("shape-name");
        summary.setId("shape-about");
        summary.getStyleClass().add("caption");
        summary.setWrapText(true);
        var gap = new Region();
        HBox.setHgrow(gap, Priority.ALWAYS);
        var row = new HBox(name, gap, CommandButton.iconButton(model.commands(), Command.RENAME_SHAPE));
        row.getStyleClass().add("header-row");
        var header = new VBox(row, summary);
        header.getStyleClass().add("light-header");
        ScrollPane scroll = SectionLayout.incrementalScroll(box -> Stream.<Supplier<Node>>of(() -> header,
                () -> SectionLayout.section(Messages.tr("Position"), vector(SceneNode.AT)),
                () -> SectionLayout.section(Messages.tr("Rotation"), numbers(SceneNode.ROTATE).toArray(Node[]::new)),
                () -> SectionLayout.section(Messages.tr("Scale"), vector(SceneNode.SCALE)))
                .map(part -> () -> SectionLayout.add(box, part.get())));
        setVgrow(scroll, Priority.ALWAYS);
        getChildren().add(scroll);
        showWhile(editor.editorStateProperty().when(tabSelected));
    }

    @Override
    Optional<SceneElement<SceneNode>> selected() {
        return editor.selection().node().map(node -> new SceneElement.OfNode(node.name()));
    }

    @Override
    String missingReason() {
        return Messages.tr("no object is selected");
    }

    @Override
    void show() {
        super.show();
        Optional<SceneNode> node = record();
        name.setText(node.map(SceneNode::name).orElse(""));
        summary.setText(node.map(NodePane::summary).orElseGet(() -> Messages.tr("Click an object in the preview or in the list")));
    }

    private static String summary(SceneNode node) {
        return switch (node) {
            case NodeGroup g -> Messages.tr("Group of {0}", g.children().size());
            case Shape s -> Messages.tr("{0}, material {1}", SectionLayout.title(OutlineCell.noun(s)), s.material());
        } + (node.visible() ? "" : Messages.tr(", hidden"));
    }

    @Override
    String id(SceneAttribute<SceneNode, ?> attribute, String part) {
        return part.isEmpty() ? "shape-" + attribute.name() : attribute.name() + "-" + part;
    }

    @Override
    String title(SceneAttribute<SceneNode, ?> attribute) {
        return attribute.name();
    }

    @Override
    String label(SceneAttribute<SceneNode, ?> attribute, String part) {
        return Messages.tr("About {0}", part);
    }
}
