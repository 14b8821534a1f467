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
import lightning.base.text.Expression;
import lightning.base.text.Language;
import lightning.base.text.Texts;
import lightning.scene.Limits;

/**
 * A number as text, or a sum that makes one ({@link Expression}). Enter or leaving the field sets it, Escape brings back what was
 * there, the up and down keys step it, and the wheel while the keyboard is here: a tenth of a step with Shift, ten with Ctrl, or Page
 * Up and Page Down. A text that is refused stays, marked.
 */
public final class NumberField extends TextField {
    private static final PseudoClass REFUSED = PseudoClass.getPseudoClass("refused");
    private static final MathContext SHORT = new MathContext(5);
    private static final int COLUMNS = 5;
    /** Turns of the wheel that follow sooner are one step to undo, nanoseconds. */
    private static final long ONE_TURN = 1_000_000_000;

    private final ReadOnlyStringWrapper refusal = new ReadOnlyStringWrapper("");
    private final Gauge gauge;
    private double value;
    /** What stands for the turns of the wheel that are one step to undo. */
    private Object turn = new Object();
    private long turned = Long.MIN_VALUE;

    /** @param title for people, and for screen readers */
    public NumberField(String title, Gauge gauge) {
        this.gauge = gauge;
        setAccessibleText(Texts.of(title));
        setPrefColumnCount(COLUMNS);
        setAlignment(Pos.CENTER_RIGHT);
        getStyleClass().add("number-field");
        setText(shown());
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
        addEventFilter(KeyEvent.KEY_PRESSED, this::press);
        addEventFilter(ScrollEvent.SCROLL, this::turn);
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
        String text = shown();
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
        gauge.set(gauge.steps().from(value, steps), null).ifPresentOrElse(this::refuse, this::revert);
    }

    private void commit() {
        if (getText().strip().equals(shown()) || isExact()) {
            revert();
        } else {
            typed().ifPresentOrElse(this::refuse, this::revert);
        }
    }

    /** Sets what the text says; returns why that was refused. */
    private Optional<String> typed() {
        return switch (Expression.read(withPoint(getText()), value, gauge.measure())) {
            case Expression.Value(double v) -> gauge.set(v, null);
            case Expression.Wrong(String reason) -> Optional.of(Texts.of(gauge.title()) + " " + reason);
        };
    }

    /** A comma is the German point; English has none in a number. */
    private static String withPoint(String text) {
        return Texts.language() == Language.GERMAN ? text.replace(',', '.') : text;
    }

    private boolean isExact() {
        return getText().strip().equals(Limits.text(value));
    }

    /** All digits where they can be edited, and few enough to read where not. */
    private String shown() {
        if (Double.isNaN(value)) {
            return "";
        }
        return isFocused() ? Limits.text(value)
                : Limits.text(BigDecimal.valueOf(value).round(SHORT).doubleValue());
    }

    /** Elsewhere the wheel scrolls what the field stands in. */
    private void turn(ScrollEvent event) {
        // With Shift the wheel of a mouse goes sideways.
        double way = event.getDeltaY() == 0 ? event.getDeltaX() : event.getDeltaY();
        if (!isFocused() || way == 0 || event.isInertia()) {
            return;
        }
        event.consume();
        if (!getText().strip().equals(shown())) {
            commit();
        }
        long now = System.nanoTime();
        if (turned == Long.MIN_VALUE || now - turned > ONE_TURN) {
            turn = new Object();
        }
        turned = now;
        double steps = Math.signum(way) * Scrub.factor(event.isShiftDown(), event.isShortcutDown());
        gauge.set(gauge.steps().from(value, steps), turn).ifPresentOrElse(this::refuse, this::revert);
    }

    private void press(KeyEvent event) {
        double steps = switch (event.getCode()) {
            case UP -> event.isShiftDown() ? Scrub.FINE : 1;
            case DOWN -> event.isShiftDown() ? -Scrub.FINE : -1;
            case PAGE_UP -> Scrub.COARSE;
            case PAGE_DOWN -> -Scrub.COARSE;
            default -> 0;
        };
        if (steps != 0) {
            step(steps);
            event.consume();
        } else if (event.getCode() == KeyCode.ESCAPE && !getText().equals(shown())) {
            revert();
            event.consume();
        }
    }
}
