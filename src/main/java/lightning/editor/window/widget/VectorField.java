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
import lightning.base.text.Messages;
import lightning.document.StepRange;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

/** Field for a position or a direction, as three numbers. */
public final class VectorField extends VBox implements ValueWidget<Vec3> {
    private static final StepRange STEPS = new StepRange(0.1, -SceneLimits.MAX_COORDINATE, SceneLimits.MAX_COORDINATE);

    private final List<NumberField> fields = new ArrayList<>();
    private final HBox row = new HBox();
    private final DisabledReason disabledReason;
    private Vec3 value = Vec3.ZERO;

    /** Receiver of vectors; returns why a vector was refused. */
    public interface Setter {
        /** @param gesture  gesture as in {@link NumberSetting#set} */
        Optional<String> set(Vec3 value, @Nullable Object gesture);
    }

    /** @param title  display title, for example "position" */
    public VectorField(String title, Setter setter) {
        row.getStyleClass().add("vector-row");
        addAxis("x", title, (x, g) -> setter.set(new Vec3(x, value.y(), value.z()), g));
        addAxis("y", title, (y, g) -> setter.set(new Vec3(value.x(), y, value.z()), g));
        addAxis("z", title, (z, g) -> setter.set(new Vec3(value.x(), value.y(), z), g));
        getStyleClass().add("vector-field");
        getChildren().addAll(row, new RefusalLabel(fields));
        disabledReason = new DisabledReason(this, row);
    }

    private void addAxis(String axis, String title, NumberSetting.Setter setter) {
        String name = Messages.tr(title) + " " + axis;
        NumberSetting setting = NumberSetting.of(name, STEPS, setter);
        NumberField field = new NumberField(name, setting);
        HBox.setHgrow(field, Priority.ALWAYS);
        Label label = new FieldLabel(axis.toUpperCase(Locale.ROOT), setting, field);
        label.getStyleClass().addAll("axis", "axis-" + axis);
        fields.add(field);
        row.getChildren().addAll(label, field);
    }

    @Override
    public void show(Vec3 v) {
        value = v;
        fields.get(0).show(v.x());
        fields.get(1).show(v.y());
        fields.get(2).show(v.z());
    }

    @Override
    public void showNothing() {
        fields.forEach(NumberField::showNothing);
    }

    @Override
    public void revert() {
        fields.forEach(NumberField::revert);
    }

    @Override
    public void setDisabledReason(Optional<String> reason) {
        if (reason.isPresent()) {
            revert();
        }
        disabledReason.set(reason);
    }
}
