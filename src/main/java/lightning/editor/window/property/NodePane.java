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
import lightning.base.text.Measure;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.NodeEdits;
import lightning.editor.document.Situation;
import lightning.editor.document.Steps;
import lightning.editor.window.command.CommandButton;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.Gauge;
import lightning.editor.window.widget.VectorField;
import lightning.scene.Group;
import lightning.scene.Limits;
import lightning.scene.Node;
import lightning.scene.Placement;
import lightning.scene.Shape;

/** The placement of the selected shape or group: where it stands, how it is turned, how large it is. */
final class NodePane extends VBox {
    private static final String NO_SHAPE = Texts.key("no shape is selected");
    private static final Steps DEGREES = new Steps(5, -Limits.MAX_ROTATION, Limits.MAX_ROTATION);

    private final SceneEditor editor;
    private final PropertyMenu menu;
    private final Label name = new Label();
    private final Label about = new Label();
    private final VectorField at;
    private final List<ArrowWidget> turns;
    private final VectorField scale;
    private String shown = "";

    /**
     * @param menu    opens on each property
     * @param inFront whether the pane is seen; else it does not follow what is edited
     */
    NodePane(SceneEditor editor, Commands commands, PropertyMenu menu, ObservableValue<Boolean> inFront) {
        this.editor = editor;
        this.menu = menu;
        setId("shape");
        getStyleClass().add("properties");
        name.setId("shape-name");
        name.getStyleClass().add("shape-name");
        about.setId("shape-about");
        about.getStyleClass().add("caption");
        about.setWrapText(true);
        at = vector("at", (p, v) -> new Placement(v, p.rotate(), p.scale()));
        turns = IntStream.range(0, 3).mapToObj(this::turn).toList();
        scale = vector("scale", (p, v) -> new Placement(p.at(), p.rotate(), v));
        var gap = new Region();
        HBox.setHgrow(gap, Priority.ALWAYS);
        var row = new HBox(name, gap, CommandButton.icon(commands, Command.RENAME_SHAPE));
        row.getStyleClass().add("header-row");
        var header = new VBox(row, about);
        header.getStyleClass().add("light-header");
        List<javafx.scene.Node> rotate = new ArrayList<>(turns);
        ScrollPane scroll = Sections.gradual(box -> Stream.of(() -> Sections.add(box, header),
                () -> Sections.add(box, Sections.section(Texts.of("Position"), at)),
                () -> Sections.add(box, Sections.section(Texts.of("Rotation"), rotate.toArray(javafx.scene.Node[]::new))),
                () -> Sections.add(box, Sections.section(Texts.of("Scale"), scale))));
        setVgrow(scroll, Priority.ALWAYS);
        getChildren().add(scroll);
        editor.situationProperty().when(inFront).subscribe(this::show);
    }

    private interface WithVector {
        Placement on(Placement placement, Vec3 v);
    }

    private VectorField vector(String property, WithVector with) {
        var field = new VectorField(property,
                (v, gesture) -> editor.edit(scene -> NodeEdits.placement(scene, shown, p -> with.on(p, v)), gesture));
        field.setId("shape-" + property);
        menu.on(field, new PropertyOwner.OfNode(editor.selection(), property));
        return field;
    }

    private ArrowWidget turn(int axis) {
        String label = List.of("x", "y", "z").get(axis);
        var widget = new ArrowWidget(Texts.of("About {0}", label), "rotate " + label, Gauge.of("rotate " + label, DEGREES, Measure.DEGREES,
                (degrees, gesture) -> editor.edit(scene -> NodeEdits.placement(scene, shown, p -> turned(p, axis, degrees)), gesture)));
        widget.setId("rotate-" + label);
        menu.on(widget, new PropertyOwner.OfNode(editor.selection(), "rotate"));
        return widget;
    }

    private static Placement turned(Placement p, int axis, double degrees) {
        Vec3 r = p.rotate();
        return new Placement(p.at(), switch (axis) {
            case 0 -> new Vec3(degrees, r.y(), r.z());
            case 1 -> new Vec3(r.x(), degrees, r.z());
            default -> new Vec3(r.x(), r.y(), degrees);
        }, p.scale());
    }

    private void show(Situation now) {
        Optional<String> obstacle = now.node().isEmpty() ? Optional.of(Texts.of(NO_SHAPE)) : Optional.empty();
        Stream.of(at, scale).forEach(f -> f.setObstacle(obstacle));
        turns.forEach(t -> t.setObstacle(obstacle));
        String selected = now.node().map(Node::name).orElse("");
        if (!selected.equals(shown)) {
            shown = selected;
            // What was typed was meant for the other shape.
            at.revert();
            scale.revert();
            turns.forEach(ArrowWidget::revert);
        }
        now.node().ifPresentOrElse(this::show, this::showNothing);
    }

    private void show(Node node) {
        name.setText(node.name());
        about.setText(switch (node) {
            case Group g -> Texts.of("Group of {0}", g.children().size());
            case Shape s -> Texts.of("{0} of material {1}", Sections.title(OutlineCell.noun(s)), s.material());
        } + (node.visible() ? "" : Texts.of(", hidden")));
        at.show(node.placement().at());
        scale.show(node.placement().scale());
        Vec3 r = node.placement().rotate();
        turns.get(0).show(r.x());
        turns.get(1).show(r.y());
        turns.get(2).show(r.z());
    }

    private void showNothing() {
        name.setText("");
        about.setText(Texts.of("Click a shape in the preview or in the list of shapes"));
        at.showNothing();
        scale.showNothing();
        turns.forEach(ArrowWidget::showNothing);
    }
}
