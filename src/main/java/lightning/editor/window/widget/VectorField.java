package lightning.editor.window.widget;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.base.math.Vec3;
import lightning.base.text.Texts;
import lightning.editor.document.Steps;
import lightning.scene.Limits;

/** A place or a direction as three numbers. */
public final class VectorField extends VBox {
    private static final Steps STEPS = new Steps(0.1, -Limits.MAX_COORDINATE, Limits.MAX_COORDINATE);

    private final List<NumberField> fields = new ArrayList<>();
    private final HBox row = new HBox();
    private final Obstacle obstacle;
    private Vec3 value = Vec3.ZERO;

    /** Sets a vector; returns why it was refused. */
    public interface Setter {
        /** @param gesture as in {@link Gauge#set} */
        Optional<String> set(Vec3 value, Object gesture);
    }

    /** @param title for people, as "position" */
    public VectorField(String title, Setter setter) {
        row.getStyleClass().add("vector-row");
        axis("x", title, (x, g) -> setter.set(new Vec3(x, value.y(), value.z()), g));
        axis("y", title, (y, g) -> setter.set(new Vec3(value.x(), y, value.z()), g));
        axis("z", title, (z, g) -> setter.set(new Vec3(value.x(), value.y(), z), g));
        getStyleClass().add("vector-field");
        getChildren().addAll(row, new Refusal(fields));
        obstacle = new Obstacle(this, row);
    }

    private void axis(String axis, String title, Gauge.Setter setter) {
        String name = Texts.of(title) + " " + axis;
        Gauge gauge = Gauge.of(name, STEPS, setter);
        NumberField field = new NumberField(name, gauge);
        HBox.setHgrow(field, Priority.ALWAYS);
        Label label = new FieldLabel(axis.toUpperCase(Locale.ROOT), gauge, field);
        label.getStyleClass().addAll("axis", "axis-" + axis);
        fields.add(field);
        row.getChildren().addAll(label, field);
    }

    /** Shows a vector. */
    public void show(Vec3 v) {
        value = v;
        fields.get(0).show(v.x());
        fields.get(1).show(v.y());
        fields.get(2).show(v.z());
    }

    /** Shows that there is no vector. */
    public void showNothing() {
        fields.forEach(NumberField::showNothing);
    }

    /** Forgets what was typed. */
    public void revert() {
        fields.forEach(NumberField::revert);
    }

    /** Disables the field and says why, a clause; or enables it. */
    public void setObstacle(Optional<String> reason) {
        if (reason.isPresent()) {
            revert();
        }
        obstacle.set(reason);
    }
}
