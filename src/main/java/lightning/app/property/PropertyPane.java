package lightning.app.property;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import javafx.scene.Node;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.app.command.CommandButton;
import lightning.app.model.EditorModel;
import lightning.app.widget.ArrowWidget;
import lightning.app.widget.ColorSliders;
import lightning.app.widget.VectorField;
import lightning.edit.Attribute;
import lightning.edit.Command;
import lightning.edit.Dial;
import lightning.edit.LightEdits;
import lightning.edit.OpenDocument;
import lightning.edit.Situation;
import lightning.math.Vec3;
import lightning.scene.Light;

/** The property editor of the selected light and the scene (paper §3.2, Figure 5). */
public final class PropertyPane extends VBox {
    private static final Optional<String> NO_LIGHT = Optional.of("no light is selected");

    private final EditorModel model;
    private final List<ArrowWidget> dials = new ArrayList<>();
    private final LightHeader header;
    private final ColorSliders color;
    private final VectorField position;
    private final VectorField direction;
    private Shown shown;

    /** @param light its number in the document's history; −1 for none */
    private record Shown(OpenDocument document, long light) {}

    public PropertyPane(EditorModel model) {
        this.model = model;
        setId("properties");
        getStyleClass().add("properties");
        header = new LightHeader(model);
        color = new ColorSliders(new LightColor(model));
        color.setId("color");
        position = vector("position", (light, v) -> light.withPosition(v));
        direction = vector("direction", (light, v) -> light.withDirection(v));
        ScrollPane scroll = Sections.scroll(header,
                Sections.section("Colour", color, dial(Dial.INTENSITY, "Intensity")),
                Sections.section("Cone", dial(Dial.ANGLE, "Angle °"), dial(Dial.DROPOFF, "Dropoff")),
                Sections.section("Attenuation", dial(Dial.CONSTANT, "Constant"), dial(Dial.LINEAR, "Linear"),
                        dial(Dial.QUADRATIC, "Quadratic")),
                Sections.section("Place", Sections.caption("Position"), position, Sections.caption("Direction"), direction, aim()),
                Sections.section("Scene", dial(Dial.AMBIENCE, "Ambience")));
        setVgrow(scroll, Priority.ALWAYS);
        getChildren().add(scroll);
        model.situationProperty().subscribe(this::show);
    }

    private ArrowWidget dial(Dial dial, String label) {
        ArrowWidget widget = DialGauge.widget(model, dial, label);
        dials.add(widget);
        return widget;
    }

    private VectorField vector(String title, BiFunction<Light, Vec3, Light> edit) {
        VectorField field = new VectorField(title, v -> model.edit(
                scene -> LightEdits.with(scene, model.selectedLight().name(), light -> edit.apply(light, v))));
        field.setId(title);
        return field;
    }

    private Node aim() {
        CommandButton aim = new CommandButton(model, Command.AIM, true);
        aim.button().setMaxWidth(Double.MAX_VALUE);
        return aim;
    }

    private void show(Situation now) {
        var selected = new Shown(model.document(), now.selected().map(l -> model.document().history().id(l.name())).orElse(-1L));
        if (!selected.equals(shown)) {
            shown = selected;
            // What was typed was meant for the other light.
            header.revert();
            color.revert();
            position.revert();
            direction.revert();
            dials.forEach(ArrowWidget::revert);
        }
        color.setObstacle(now.selected().isEmpty() ? NO_LIGHT : Optional.empty());
        position.setObstacle(now.selected().isEmpty() ? NO_LIGHT : Optional.empty());
        direction.setObstacle(obstacle(now, Attribute.DIRECTION));
        now.selected().ifPresentOrElse(light -> {
            color.show(light.color());
            position.show(light.position());
            direction.show(light.direction());
        }, () -> {
            color.showNothing();
            position.showNothing();
            direction.showNothing();
        });
    }

    private static Optional<String> obstacle(Situation now, Attribute attribute) {
        return now.selected().isEmpty() ? NO_LIGHT : attribute.obstacle(now.selected().get().type());
    }
}
