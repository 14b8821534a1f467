package lightning.editor.window.widget;

import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.scene.Node;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import org.jspecify.annotations.Nullable;

/** Changes a number by dragging a handle next to its field. A drag is one undo step; Escape cancels it. */
final class NumberScrubber {
    /** Step factor with Shift. */
    static final double FINE = 0.1;
    /** Step factor with Ctrl. */
    static final double COARSE = 10;
    private static final double PIXELS_PER_STEP = 4;
    /** Tolerance for small movements during a click, pixels. */
    private static final double CLICK_PIXELS = 3;
    private static final double FRACTIONS_PER_STEP = 1000;
    private static final PseudoClass DRAGGED = PseudoClass.getPseudoClass("dragged");

    private final Node handle;
    private final NumberSetting setting;
    private final NumberField field;
    private final Direction direction;
    private final Click onClick;
    private @Nullable Drag drag;

    /** Direction that increases the number. */
    enum Direction {
        UP, RIGHT
    }

    /** Handles a press without a drag. */
    interface Click {
        void onClick(MouseEvent event);
    }

    /** State between press and release of the mouse. */
    private static final class Drag {
        private final double startValue;
        private double position;
        private double steps;
        private boolean hasMoved;

        Drag(double startValue, double position) {
            this.startValue = startValue;
            this.position = position;
        }
    }

    private NumberScrubber(Node handle, NumberSetting setting, NumberField field, Direction direction, Click onClick) {
        this.handle = handle;
        this.setting = setting;
        this.field = field;
        this.direction = direction;
        this.onClick = onClick;
    }

    /** Makes a node a drag handle. */
    static void install(Node handle, NumberSetting setting, NumberField field, Direction direction, Click onClick) {
        var scrub = new NumberScrubber(handle, setting, field, direction, onClick);
        handle.setOnMousePressed(scrub::press);
        handle.setOnMouseDragged(scrub::drag);
        handle.setOnMouseReleased(scrub::release);
        handle.addEventHandler(KeyEvent.KEY_PRESSED, scrub::handleKey);
    }

    private double position(MouseEvent event) {
        return direction == Direction.UP ? -event.getScreenY() : event.getScreenX();
    }

    private void press(MouseEvent event) {
        if (event.getButton() == MouseButton.PRIMARY) {
            handle.requestFocus();
            field.revert();
            drag = new Drag(field.value(), position(event));
            handle.pseudoClassStateChanged(DRAGGED, true);
            event.consume();
        }
    }

    private void drag(MouseEvent event) {
        if (drag == null) {
            return;
        }
        double distance = position(event) - drag.position;
        if (!drag.hasMoved && Math.abs(distance) < CLICK_PIXELS) {
            return;
        }
        drag.hasMoved = true;
        drag.position = position(event);
        drag.steps += distance / PIXELS_PER_STEP * factor(event.isShiftDown(), event.isShortcutDown());
        // Rounds to a thousandth of a step to keep the number short.
        show(setting.set(setting.steps().addSteps(drag.startValue, Math.rint(drag.steps * FRACTIONS_PER_STEP) / FRACTIONS_PER_STEP), drag));
        event.consume();
    }

    private void release(MouseEvent event) {
        if (drag == null || event.getButton() != MouseButton.PRIMARY) {
            return;
        }
        boolean clicked = !drag.hasMoved;
        endDrag();
        if (clicked) {
            onClick.onClick(event);
        }
        event.consume();
    }

    private void handleKey(KeyEvent event) {
        if (event.getCode() == KeyCode.ESCAPE && drag != null) {
            if (drag.hasMoved) {
                show(setting.set(drag.startValue, drag));
            }
            endDrag();
            event.consume();
        }
    }

    private void endDrag() {
        drag = null;
        handle.pseudoClassStateChanged(DRAGGED, false);
    }

    private void show(Optional<String> refusal) {
        refusal.ifPresentOrElse(field::refuse, field::revert);
    }

    /** Returns the step factor of the modifier keys. */
    static double factor(boolean shift, boolean shortcut) {
        return shift ? FINE : shortcut ? COARSE : 1;
    }
}
