package lightning.editor.window.widget;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Optional;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.css.PseudoClass;
import javafx.geometry.Pos;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.ScrollEvent;
import lightning.base.text.Language;
import lightning.base.text.Messages;
import lightning.base.text.NumberExpression;
import lightning.scene.SceneLimits;

/**
 * A number as text, or a sum that makes one ({@link NumberExpression}). Enter or leaving the field sets it, Escape brings back what was
 * there, the up and down keys step it, and the wheel while the keyboard is here: a tenth of a step with Shift, ten with Ctrl, or Page
 * Up and Page Down. A text that is refused stays, marked.
 */
public final class NumberField extends TextField {
    private static final PseudoClass REFUSED = PseudoClass.getPseudoClass("refused");
    private static final MathContext DISPLAY_PRECISION = new MathContext(5);
    private static final int COLUMNS = 5;
    /** Turns of the wheel that follow sooner are one step to undo, nanoseconds. */
    private static final long WHEEL_GESTURE_NS = 1_000_000_000;

    private final ReadOnlyStringWrapper refusal = new ReadOnlyStringWrapper("");
    private final NumberSetting setting;
    private double value;
    /** What stands for the turns of the wheel that are one step to undo. */
    private Object wheelGesture = new Object();
    private long lastWheelNs = Long.MIN_VALUE;

    /** @param title for people, and for screen readers */
    public NumberField(String title, NumberSetting setting) {
        this.setting = setting;
        setAccessibleText(Messages.tr(title));
        setPrefColumnCount(COLUMNS);
        setAlignment(Pos.CENTER_RIGHT);
        getStyleClass().add("number-field");
        setText(displayText());
        setOnAction(_ -> {
            commit();
            // Of a long number its begin is seen, where the caret is.
            selectRange(getLength(), 0);
        });
        focusedProperty().addListener((_, wasFocused, _) -> {
            if (wasFocused) {
                commit();
            } else if (refusal.get().isEmpty()) {
                revert();
            }
        });
        addEventFilter(KeyEvent.KEY_PRESSED, this::handleKey);
        addEventFilter(ScrollEvent.SCROLL, this::handleWheel);
        refusal.addListener((_, _, now) -> {
            pseudoClassStateChanged(REFUSED, !now.isEmpty());
            setAccessibleHelp(now);
        });
    }

    /** Why the text is not the value, a clause; empty if it is. */
    public ReadOnlyStringProperty refusalProperty() {
        return refusal.getReadOnlyProperty();
    }

    /** The value that was shown last, to all its digits; NaN where there is none. */
    public double value() {
        return value;
    }

    /** Shows a value. A text that is being typed stays as long as the value does. */
    public void show(double v) {
        if (Double.compare(v, value) != 0) {
            value = v;
            revert();
        }
    }

    /** Shows that there is no value. */
    public void showNothing() {
        value = Double.NaN;
        revert();
    }

    /** Forgets what was typed. */
    public void revert() {
        refusal.set("");
        String text = displayText();
        // Setting a text, even the one that is there, takes long and empties its own undo, which comes before the document's.
        if (!getText().equals(text) || isUndoable() || isRedoable()) {
            setText(text);
        }
    }

    /** Marks the field with the reason why an edit was refused. */
    void refuse(String reason) {
        refusal.set(reason);
    }

    /** Steps the value, after what was typed is set. */
    void step(double steps) {
        commit();
        setting.set(setting.steps().addSteps(value, steps), null).ifPresentOrElse(this::refuse, this::revert);
    }

    private void commit() {
        if (getText().strip().equals(displayText()) || isExact()) {
            revert();
        } else {
            commitText().ifPresentOrElse(this::refuse, this::revert);
        }
    }

    /** Sets what the text says; returns why that was refused. */
    private Optional<String> commitText() {
        return switch (NumberExpression.evaluate(normalizeDecimal(getText()), value, setting.measure())) {
            case NumberExpression.Value(double v) -> setting.set(v, null);
            case NumberExpression.Invalid(String reason) -> Optional.of(Messages.tr(setting.title()) + " " + reason);
        };
    }

    /** A comma is the German point; English has none in a number. */
    private static String normalizeDecimal(String text) {
        return Messages.language() == Language.GERMAN ? text.replace(',', '.') : text;
    }

    private boolean isExact() {
        return getText().strip().equals(SceneLimits.format(value));
    }

    /** All digits where they can be edited, and few enough to read where not. */
    private String displayText() {
        if (Double.isNaN(value)) {
            return "";
        }
        return isFocused() ? SceneLimits.format(value)
                : SceneLimits.format(BigDecimal.valueOf(value).round(DISPLAY_PRECISION).doubleValue());
    }

    /** Elsewhere the wheel scrolls what the field stands in. */
    private void handleWheel(ScrollEvent event) {
        // With Shift the wheel of a mouse goes sideways.
        double delta = event.getDeltaY() == 0 ? event.getDeltaX() : event.getDeltaY();
        if (!isFocused() || delta == 0 || event.isInertia()) {
            return;
        }
        event.consume();
        if (!getText().strip().equals(displayText())) {
            commit();
        }
        long now = System.nanoTime();
        if (lastWheelNs == Long.MIN_VALUE || now - lastWheelNs > WHEEL_GESTURE_NS) {
            wheelGesture = new Object();
        }
        lastWheelNs = now;
        double steps = Math.signum(delta) * NumberScrubber.factor(event.isShiftDown(), event.isShortcutDown());
        setting.set(setting.steps().addSteps(value, steps), wheelGesture).ifPresentOrElse(this::refuse, this::revert);
    }

    private void handleKey(KeyEvent event) {
        double steps = switch (event.getCode()) {
            case UP -> event.isShiftDown() ? NumberScrubber.FINE : 1;
            case DOWN -> event.isShiftDown() ? -NumberScrubber.FINE : -1;
            case PAGE_UP -> NumberScrubber.COARSE;
            case PAGE_DOWN -> -NumberScrubber.COARSE;
            default -> 0;
        };
        if (steps != 0) {
            step(steps);
            event.consume();
        } else if (event.getCode() == KeyCode.ESCAPE && !getText().equals(displayText())) {
            revert();
            event.consume();
        }
    }
}
