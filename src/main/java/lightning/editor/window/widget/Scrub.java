package lightning.editor.window.widget;

import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.scene.Node;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;

/** A number that is dragged by what stands beside its field: all of a drag is one step to undo, and Escape brings back what was there. */
final class Scrub {
    /** Steps, with Shift. */
    static final double FINE = 0.1;
    /** Steps, with Ctrl. */
    static final double COARSE = 10;
    private static final double PIXELS_PER_STEP = 4;
    /** A hand that clicks moves a little. */
    private static final double CLICK_PIXELS = 3;
    private static final double HAIR = 1000;
    private static final PseudoClass DRAGGED = PseudoClass.getPseudoClass("dragged");

    private final Node handle;
    private final Gauge gauge;
    private final NumberField field;
    private final Way way;
    private final Click click;
    private Drag drag;

    /** Which way makes the number larger. */
    enum Way {
        UP, RIGHT
    }

    /** Hears of a press that was no drag. */
    interface Click {
        void at(MouseEvent event);
    }

    /** One press of the mouse, until its release. */
    private static final class Drag {
        private final double from;
        private double place;
        private double steps;
        private boolean moved;

        Drag(double from, double place) {
            this.from = from;
            this.place = place;
        }
    }

    private Scrub(Node handle, Gauge gauge, NumberField field, Way way, Click click) {
        this.handle = handle;
        this.gauge = gauge;
        this.field = field;
        this.way = way;
        this.click = click;
    }

    /** Lets a node be dragged. */
    static void by(Node handle, Gauge gauge, NumberField field, Way way, Click click) {
        var scrub = new Scrub(handle, gauge, field, way, click);
        handle.setOnMousePressed(scrub::press);
        handle.setOnMouseDragged(scrub::drag);
        handle.setOnMouseReleased(scrub::release);
        handle.addEventHandler(KeyEvent.KEY_PRESSED, scrub::key);
    }

    private double place(MouseEvent event) {
        return way == Way.UP ? -event.getScreenY() : event.getScreenX();
    }

    private void press(MouseEvent event) {
        if (event.getButton() == MouseButton.PRIMARY) {
            handle.requestFocus();
            field.revert();
            drag = new Drag(field.value(), place(event));
            handle.pseudoClassStateChanged(DRAGGED, true);
            event.consume();
        }
    }

    private void drag(MouseEvent event) {
        if (drag == null) {
            return;
        }
        double way = place(event) - drag.place;
        if (!drag.moved && Math.abs(way) < CLICK_PIXELS) {
            return;
        }
        drag.moved = true;
        drag.place = place(event);
        drag.steps += way / PIXELS_PER_STEP * factor(event.isShiftDown(), event.isShortcutDown());
        // A thousandth of a step is finer than a hand, and keeps the number short.
        show(gauge.set(gauge.steps().from(drag.from, Math.rint(drag.steps * HAIR) / HAIR), drag));
        event.consume();
    }

    private void release(MouseEvent event) {
        if (drag == null || event.getButton() != MouseButton.PRIMARY) {
            return;
        }
        boolean clicked = !drag.moved;
        end();
        if (clicked) {
            click.at(event);
        }
        event.consume();
    }

    private void key(KeyEvent event) {
        if (event.getCode() == KeyCode.ESCAPE && drag != null) {
            if (drag.moved) {
                show(gauge.set(drag.from, drag));
            }
            end();
            event.consume();
        }
    }

    private void end() {
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
