package lightning.editor.window.property;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import lightning.base.math.Vec3;
import lightning.base.text.Messages;
import lightning.base.text.NumberUnit;
import lightning.editor.document.Command;
import lightning.editor.document.EditorState;
import lightning.editor.document.NodeEdits;
import lightning.editor.document.StepRange;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.NumberSetting;
import lightning.editor.window.widget.VectorField;
import lightning.scene.SceneElement;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;

/** Property editor of the selected shape's or group's placement: position, rotation and scale. */
final class NodePane extends VBox {
    private static final String NO_SHAPE = Messages.key("no object is selected");
    private static final StepRange DEGREES = new StepRange(5, -SceneLimits.MAX_ROTATION, SceneLimits.MAX_ROTATION);

    private final SceneEditor editor;
    private final PropertyMenu menu;
    private final Label name = new Label();
    private final Label summary = new Label();
    private final VectorField position;
    private final List<ArrowWidget> rotations;
    private final VectorField scale;
    private String shownName = "";

    /**
     * @param menu  context menu of the properties
     * @param tabSelected  true while the pane is visible; it is updated only then
     */
    NodePane(SceneEditor editor, CommandRegistry commands, PropertyMenu menu, ObservableValue<Boolean> tabSelected) {
        this.editor = editor;
        this.menu = menu;
        setId("shape");
        getStyleClass().add("properties");
        name.setId("shape-name");
        name.getStyleClass().add("shape-name");
        summary.setId("shape-about");
        summary.getStyleClass().add("caption");
        summary.setWrapText(true);
        position = vector("at", (p, v) -> new Placement(v, p.rotation(), p.scale()));
        rotations = IntStream.range(0, 3).mapToObj(this::rotationWidget).toList();
        scale = vector("scale", (p, v) -> new Placement(p.position(), p.rotation(), v));
        var gap = new Region();
        HBox.setHgrow(gap, Priority.ALWAYS);
        var row = new HBox(name, gap, CommandButton.iconButton(commands, Command.RENAME_SHAPE));
        row.getStyleClass().add("header-row");
        var header = new VBox(row, summary);
        header.getStyleClass().add("light-header");
        List<javafx.scene.Node> rotate = new ArrayList<>(rotations);
        ScrollPane scroll = SectionLayout.incrementalScroll(box -> Stream.of(() -> SectionLayout.add(box, header),
                () -> SectionLayout.add(box, SectionLayout.section(Messages.tr("Position"), position)),
                () -> SectionLayout.add(box, SectionLayout.section(Messages.tr("Rotation"), rotate.toArray(javafx.scene.Node[]::new))),
                () -> SectionLayout.add(box, SectionLayout.section(Messages.tr("Scale"), scale))));
        setVgrow(scroll, Priority.ALWAYS);
        getChildren().add(scroll);
        editor.editorStateProperty().when(tabSelected).subscribe(this::show);
    }

    private interface VectorEdit {
        Placement apply(Placement placement, Vec3 v);
    }

    private VectorField vector(String property, VectorEdit edit) {
        var field = new VectorField(property,
                (v, gesture) -> editor.edit(scene -> NodeEdits.setPlacement(scene, shownName, p -> edit.apply(p, v)), gesture));
        field.setId("shape-" + property);
        menu.attach(field, property(property.equals("at") ? SceneNode.AT : SceneNode.SCALE));
        return field;
    }

    private ArrowWidget rotationWidget(int axis) {
        String label = List.of("x", "y", "z").get(axis);
        var widget = new ArrowWidget(Messages.tr("About {0}", label), "rotate " + label,
                NumberSetting.of("rotate " + label, DEGREES, NumberUnit.DEGREES,
                        (degrees, gesture) -> editor
                                .edit(scene -> NodeEdits.setPlacement(scene, shownName, p -> withRotation(p, axis, degrees)), gesture)));
        widget.setId("rotate-" + label);
        menu.attach(widget, property(SceneNode.ROTATE));
        return widget;
    }

    private SelectedProperty<SceneNode> property(SceneAttribute<SceneNode, ?> attribute) {
        return new SelectedProperty<>(() -> editor.selection().node().map(n -> new SceneElement.OfNode(n.name())), attribute);
    }

    private static Placement withRotation(Placement p, int axis, double degrees) {
        Vec3 r = p.rotation();
        return new Placement(p.position(), switch (axis) {
            case 0 -> new Vec3(degrees, r.y(), r.z());
            case 1 -> new Vec3(r.x(), degrees, r.z());
            default -> new Vec3(r.x(), r.y(), degrees);
        }, p.scale());
    }

    private void show(EditorState state) {
        Optional<String> reason = state.selectedNode().isEmpty() ? Optional.of(Messages.tr(NO_SHAPE)) : Optional.empty();
        Stream.of(position, scale).forEach(f -> f.setDisabledReason(reason));
        rotations.forEach(t -> t.setDisabledReason(reason));
        String selected = state.selectedNode().map(SceneNode::name).orElse("");
        if (!selected.equals(shownName)) {
            shownName = selected;
            // Uncommitted input belongs to the other shape.
            position.revert();
            scale.revert();
            rotations.forEach(ArrowWidget::revert);
        }
        state.selectedNode().ifPresentOrElse(this::show, this::showNothing);
    }

    private void show(SceneNode node) {
        name.setText(node.name());
        summary.setText(switch (node) {
            case NodeGroup g -> Messages.tr("Group of {0}", g.children().size());
            case Shape s -> Messages.tr("{0}, material {1}", SectionLayout.title(OutlineCell.noun(s)), s.material());
        } + (node.visible() ? "" : Messages.tr(", hidden")));
        position.show(node.placement().position());
        scale.show(node.placement().scale());
        Vec3 r = node.placement().rotation();
        rotations.get(0).show(r.x());
        rotations.get(1).show(r.y());
        rotations.get(2).show(r.z());
    }

    private void showNothing() {
        name.setText("");
        summary.setText(Messages.tr("Click an object in the preview or in the list"));
        position.showNothing();
        scale.showNothing();
        rotations.forEach(ArrowWidget::showNothing);
    }
}
