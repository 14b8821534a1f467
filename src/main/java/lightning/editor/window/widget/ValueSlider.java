package lightning.editor.window.widget;

import java.util.function.DoubleUnaryOperator;
import javafx.scene.control.Slider;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import lightning.base.text.Messages;
import lightning.document.StepRange;
import org.jspecify.annotations.Nullable;

/** Slider beside a number field. A drag is one undo step; Escape cancels it. */
final class ValueSlider extends Slider {
    private static final int SUBSTEPS_PER_STEP = 100;
    private static final int KEY_STEPS = 20;
    /** A longer range cannot be set with a slider: a pixel would be several steps. */
    private static final double MAX_STEPS = 400;

    private final NumberSetting setting;
    private final Scale scale;
    private final NumberField field;
    private @Nullable Object gesture;
    private double startValue;
    private boolean isUpdating;

    /**
     * Mapping of values to positions on the track.
     *
     * @param min  value at the left end
     * @param max  value at the right end
     * @param toPosition  converts a value to a position, in any unit
     * @param toValue  converts a position to a value
     */
    record Scale(double min, double max, DoubleUnaryOperator toPosition, DoubleUnaryOperator toValue) {
        static Scale linear(double min, double max) {
            return new Scale(min, max, DoubleUnaryOperator.identity(), DoubleUnaryOperator.identity());
        }

        /** Returns the value at a fraction of the track, 0…1. */
        double valueAt(double fraction) {
            double left = toPosition.applyAsDouble(min);
            return toValue.applyAsDouble(left + fraction * (toPosition.applyAsDouble(max) - left));
        }
    }

    ValueSlider(String title, Scale scale, NumberSetting setting, NumberField field) {
        super(scale.toPosition().applyAsDouble(scale.min()), scale.toPosition().applyAsDouble(scale.max()), 0);
        this.setting = setting;
        this.scale = scale;
        this.field = field;
        setAccessibleText(Messages.tr("{0} slider", title));
        setBlockIncrement((getMax() - getMin()) / KEY_STEPS);
        addEventFilter(MouseEvent.MOUSE_PRESSED, _ -> startDrag());
        addEventFilter(MouseEvent.MOUSE_RELEASED, _ -> gesture = null);
        addEventFilter(KeyEvent.KEY_PRESSED, this::handleKey);
        valueProperty().addListener((_, _, now) -> slide(now.doubleValue()));
    }

    /** Returns whether a slider can set each step of a number. */
    static boolean serves(StepRange steps) {
        return (steps.max() - steps.min()) / steps.step() <= MAX_STEPS;
    }

    /** Moves the thumb to the field's value. */
    void update() {
        moveTo(scale.toPosition().applyAsDouble(Math.clamp(field.value(), scale.min(), scale.max())));
    }

    /** Moves the thumb to the left. */
    void showNothing() {
        moveTo(getMin());
    }

    private void moveTo(double position) {
        isUpdating = true;
        setValue(position);
        isUpdating = false;
    }

    private void startDrag() {
        gesture = new Object();
        startValue = field.value();
    }

    private void slide(double position) {
        if (isUpdating) {
            return;
        }
        double substep = setting.steps().step() / SUBSTEPS_PER_STEP;
        double value = setting.steps().addSteps(0, Math.rint(scale.toValue().applyAsDouble(position) / substep) / SUBSTEPS_PER_STEP);
        setting.set(Math.clamp(value, scale.min(), scale.max()), gesture).ifPresentOrElse(field::refuse, field::revert);
        update();
    }

    private void handleKey(KeyEvent event) {
        if (event.getCode() == KeyCode.ESCAPE && gesture != null) {
            setting.set(startValue, gesture);
            update();
            gesture = null;
            event.consume();
        }
    }
}
