package lightning.editor.window.widget;

import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.scene.Node;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;

/** A number that is dragged by what stands beside its field: all of a drag is one step to undo, and Escape brings back what was there. */
final class NumberScrubber {
    /** Steps, with Shift. */
    static final double FINE = 0.1;
    /** Steps, with Ctrl. */
    static final double COARSE = 10;
    private static final double PIXELS_PER_STEP = 4;
    /** A hand that clicks moves a little. */
    private static final double CLICK_PIXELS = 3;
    private static final double FRACTIONS_PER_STEP = 1000;
    private static final PseudoClass DRAGGED = PseudoClass.getPseudoClass("dragged");

    private final Node handle;
    private final NumberSetting setting;
    private final NumberField field;
    private final Direction direction;
    private final Click onClick;
    private Drag drag;

    /** Which way makes the number larger. */
    enum Direction {
        UP, RIGHT
    }

    /** Hears of a press that was no drag. */
    interface Click {
        void onClick(MouseEvent event);
    }

    /** One press of the mouse, until its release. */
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

    /** Lets a node be dragged. */
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
        // A thousandth of a step is finer than a hand, and keeps the number short.
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

    /** Steps for one. */
    static double factor(boolean shift, boolean shortcut) {
        return shift ? FINE : shortcut ? COARSE : 1;
    }
}
