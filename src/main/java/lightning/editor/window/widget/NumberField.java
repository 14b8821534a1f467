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
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import lightning.base.text.Language;
import lightning.base.text.Messages;
import lightning.base.text.NumberExpression;
import lightning.scene.value.SceneLimits;

/**
 * Text field for a number or an expression ({@link NumberExpression}).
 *
 * <p>Enter or losing focus commits the text; Escape reverts it. The Up and Down keys, and the wheel while focused, change the value by a
 * step; Shift makes steps a tenth, and Ctrl or Page Up and Page Down ten times as large. A refused text stays and is marked.
 */
public final class NumberField extends TextField {
    private static final PseudoClass REFUSED = PseudoClass.getPseudoClass("refused");
    private static final MathContext DISPLAY_PRECISION = new MathContext(5);
    private static final MathContext EXPONENT_PRECISION = new MathContext(4);
    /** Has more digits than a field has room for. */
    private static final BigDecimal MIN_WITH_EXPONENT = BigDecimal.valueOf(1_000_000);
    private static final int COLUMNS = 5;
    /** Wheel events within this time are one undo step, nanoseconds. */
    private static final long WHEEL_GESTURE_NS = 1_000_000_000;

    private final ReadOnlyStringWrapper refusal = new ReadOnlyStringWrapper("");
    private final NumberSetting setting;
    private double value;
    /** Gesture that groups wheel events into one undo step. */
    private Object wheelGesture = new Object();
    /** True from a press that focused the field to its release. */
    private boolean isFocusedByPress;
    private long lastWheelNs = Long.MIN_VALUE;

    /** @param title  name for the user and for screen readers */
    public NumberField(String title, NumberSetting setting) {
        this.setting = setting;
        setAccessibleText(Messages.tr(title));
        setPrefColumnCount(COLUMNS);
        setAlignment(Pos.CENTER_RIGHT);
        getStyleClass().add("number-field");
        setText(displayText());
        setOnAction(_ -> {
            commit();
            selectFromEnd();
        });
        focusedProperty().addListener((_, wasFocused, _) -> {
            if (wasFocused) {
                commit();
            } else if (refusal.get().isEmpty()) {
                revert();
            }
        });
        addEventFilter(MouseEvent.MOUSE_PRESSED, _ -> isFocusedByPress = !isFocused());
        addEventHandler(MouseEvent.MOUSE_RELEASED, _ -> {
            if (isFocusedByPress && getSelection().getLength() == 0) {
                selectFromEnd();
            }
            isFocusedByPress = false;
        });
        addEventFilter(KeyEvent.KEY_PRESSED, this::handleKey);
        addEventFilter(ScrollEvent.SCROLL, this::handleWheel);
        refusal.addListener((_, _, now) -> {
            pseudoClassStateChanged(REFUSED, !now.isEmpty());
            setAccessibleHelp(now);
        });
    }

    /** Selects the text with the caret at its start, so that a long number shows its leading digits. */
    private void selectFromEnd() {
        selectRange(getLength(), 0);
    }

    /** Reason why the text was refused, as a clause; empty if it was not. */
    public ReadOnlyStringProperty refusalProperty() {
        return refusal.getReadOnlyProperty();
    }

    /** Returns the last shown value at full precision; NaN for none. */
    public double value() {
        return value;
    }

    /** Shows a value. Uncommitted input stays as long as the value does not change. */
    public void show(double v) {
        if (Double.compare(v, value) != 0) {
            value = v;
            revert();
        }
    }

    /** Clears the field. */
    public void showNothing() {
        value = Double.NaN;
        revert();
    }

    /** Discards uncommitted input. */
    public void revert() {
        refusal.set("");
        String text = displayText();
        // Setting even an equal text is slow and clears the field's own undo, which precedes the document's.
        if (!getText().equals(text) || isUndoable() || isRedoable()) {
            setText(text);
        }
    }

    /** Marks the field with the reason of a refused edit. */
    void refuse(String reason) {
        refusal.set(reason);
    }

    /** Commits the text, then changes the value by steps. */
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

    /** Commits the text. Returns why it was refused, or empty. */
    private Optional<String> commitText() {
        return switch (NumberExpression.evaluate(normalizeDecimal(getText()), value, setting.measure())) {
            case NumberExpression.Value(double v) -> setting.set(v, null);
            case NumberExpression.Invalid(String reason) -> Optional.of(Messages.tr(setting.title()) + " " + reason);
        };
    }

    /** Accepts a decimal comma in German. */
    private static String normalizeDecimal(String text) {
        return Messages.language() == Language.GERMAN ? text.replace(',', '.') : text;
    }

    private boolean isExact() {
        return getText().strip().equals(SceneLimits.format(value));
    }

    /** Returns all digits while focused, else a rounded number. */
    private String displayText() {
        if (Double.isNaN(value)) {
            return "";
        }
        if (isFocused()) {
            return SceneLimits.format(value);
        }
        BigDecimal rounded = BigDecimal.valueOf(value).round(DISPLAY_PRECISION);
        return rounded.abs().compareTo(MIN_WITH_EXPONENT) >= 0 ? withExponent(rounded) : SceneLimits.format(rounded.doubleValue());
    }

    /** Returns a number as {@code 2.754e7}: cut digits would look like a smaller number. */
    private static String withExponent(BigDecimal number) {
        BigDecimal rounded = number.round(EXPONENT_PRECISION);
        int exponent = rounded.precision() - rounded.scale() - 1;
        return SceneLimits.format(rounded.movePointLeft(exponent).doubleValue()) + "e" + exponent;
    }

    /** Steps the value by the wheel. Unfocused, the wheel scrolls the surrounding pane. */
    private void handleWheel(ScrollEvent event) {
        // Shift turns wheel events horizontal.
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
