package lightning.app.widget;

import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.scene.AccessibleRole;
import javafx.scene.Cursor;
import javafx.scene.control.Tooltip;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;

/** The arrow of an {@link ArrowWidget}: drag it up or down, or click its upper or its lower half. */
final class ArrowPad extends VBox {
    /** Steps, with Shift. */
    static final double FINE = 0.1;
    /** Steps, with Ctrl. */
    static final double COARSE = 10;
    private static final double PIXELS_PER_STEP = 4;
    /** A hand that clicks moves a little. */
    private static final double CLICK_PIXELS = 3;
    private static final double HAIR = 1000;
    private static final PseudoClass DRAGGED = PseudoClass.getPseudoClass("dragged");

    private final Gauge gauge;
    private final NumberField field;
    private Drag drag;

    /** One press of the mouse, until its release. */
    private static final class Drag {
        private final double from;
        private double y;
        private double steps;
        private boolean moved;

        Drag(double from, double y) {
            this.from = from;
            this.y = y;
        }
    }

    ArrowPad(Gauge gauge, NumberField field) {
        super(arrow("up"), arrow("down"));
        this.gauge = gauge;
        this.field = field;
        getStyleClass().add("arrow-pad");
        setAccessibleRole(AccessibleRole.SPINNER);
        setAccessibleText(field.getAccessibleText());
        setCursor(Cursor.V_RESIZE);
        Tooltip.install(this, new Tooltip("Drag up or down, or click a half; Shift finer, Ctrl coarser"));
        setOnMousePressed(this::press);
        setOnMouseDragged(this::drag);
        setOnMouseReleased(this::release);
        addEventHandler(KeyEvent.KEY_PRESSED, this::key);
    }

    private static Region arrow(String name) {
        Region arrow = new Region();
        arrow.getStyleClass().addAll("arrow", name);
        arrow.setMouseTransparent(true);
        return arrow;
    }

    private void press(MouseEvent event) {
        if (event.getButton() == MouseButton.PRIMARY) {
            requestFocus();
            field.revert();
            drag = new Drag(field.value(), event.getScreenY());
            pseudoClassStateChanged(DRAGGED, true);
            event.consume();
        }
    }

    private void drag(MouseEvent event) {
        if (drag == null) {
            return;
        }
        double up = drag.y - event.getScreenY();
        if (!drag.moved && Math.abs(up) < CLICK_PIXELS) {
            return;
        }
        drag.moved = true;
        drag.y = event.getScreenY();
        drag.steps += up / PIXELS_PER_STEP * factor(event);
        // A thousandth of a step is finer than a hand, and keeps the number short.
        show(gauge.set(gauge.steps().from(drag.from, Math.rint(drag.steps * HAIR) / HAIR), drag));
        event.consume();
    }

    private void release(MouseEvent event) {
        if (drag == null || event.getButton() != MouseButton.PRIMARY) {
            return;
        }
        if (!drag.moved) {
            double side = event.getY() < getHeight() / 2 ? 1 : -1;
            show(gauge.set(gauge.steps().from(field.value(), side * factor(event)), null));
        }
        end();
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
        pseudoClassStateChanged(DRAGGED, false);
    }

    private void show(Optional<String> refusal) {
        refusal.ifPresentOrElse(field::refuse, field::revert);
    }

    private static double factor(MouseEvent event) {
        if (event.isShiftDown()) {
            return FINE;
        }
        return event.isShortcutDown() ? COARSE : 1;
    }
}
