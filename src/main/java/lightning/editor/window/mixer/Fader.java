package lightning.editor.window.mixer;

import javafx.beans.property.DoubleProperty;
import javafx.beans.property.SimpleDoubleProperty;
import javafx.scene.AccessibleAttribute;
import javafx.scene.AccessibleRole;
import javafx.scene.Cursor;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Region;

/**
 * A fader in stops. A drag moves it, ten times finer with Shift, and Escape takes the drag back; a double click sets 0 stops; the up
 * and down keys go a tenth of a stop, a hundredth with Shift, and Page Up and Page Down one stop. At its lower end it is dark.
 */
final class Fader extends Region {
    private static final double CAP = 16;
    private static final double FINE = 0.1;
    private static final double KEY = 0.1;
    /** Pixels from the press: less is a hand that shakes in a double click. */
    private static final double DRAGGED = 3;
    /** Stops that a drag sets are whole hundredths. */
    private static final double GRAIN = 100;

    private final double range;
    private final boolean darkens;
    private final Hand hand;
    private final Region slot = new Region();
    private final Region zero = new Region();
    private final Region cap = new Region();
    private final DoubleProperty stops = new SimpleDoubleProperty();
    private Object gesture;
    /** Whether the last press became a drag: a press soon after it is no double click. */
    private boolean dragged;
    private double pressedY;
    private double from;
    private double at;
    private double lastY;

    /** What the fader moves. */
    interface Hand {
        /** @param gesture a new object for each drag; null for a step of its own */
        void move(double stops, Object gesture);

        /** A drag begins, of which the next moves with this gesture are. */
        void begin();

        /** The drag is over. */
        void end();
    }

    /**
     * @param range   stops up and down from 0
     * @param darkens whether the lower end is no light at all
     */
    Fader(String title, double range, boolean darkens, Hand hand) {
        this.range = range;
        this.darkens = darkens;
        this.hand = hand;
        getStyleClass().add("fader");
        slot.getStyleClass().add("slot");
        zero.getStyleClass().add("zero");
        cap.getStyleClass().add("cap");
        getChildren().addAll(slot, zero, cap);
        getChildren().forEach(part -> part.setMouseTransparent(true));
        setAccessibleRole(AccessibleRole.SLIDER);
        setAccessibleText(title);
        setFocusTraversable(true);
        setCursor(Cursor.V_RESIZE);
        setOnMousePressed(this::press);
        setOnMouseDragged(this::drag);
        setOnMouseReleased(_ -> release());
        addEventHandler(KeyEvent.KEY_PRESSED, this::key);
        stops.subscribe(_ -> requestLayout());
    }

    /** Shows a value; −∞ is dark. */
    void show(double v) {
        stops.set(v);
    }

    /** What is shown, stops. */
    double stops() {
        return stops.get();
    }

    /** Where the middle of the cap is for so many stops, pixels from the top. */
    double place(double v) {
        double part = (Math.clamp(v, -range, range) + range) / (2 * range);
        return CAP / 2 + (1 - part) * (getHeight() - CAP);
    }

    private double stopsPerPixel() {
        return 2 * range / Math.max(1, getHeight() - CAP);
    }

    private void press(MouseEvent e) {
        requestFocus();
        if (e.getButton() != MouseButton.PRIMARY) {
            return;
        }
        if (e.getClickCount() == 2 && !dragged) {
            hand.move(0, null);
            return;
        }
        dragged = false;
        pressedY = e.getY();
        gesture = new Object();
        from = stops.get();
        at = Math.clamp(from, -range, range);
        lastY = e.getY();
        hand.begin();
        e.consume();
    }

    private void drag(MouseEvent e) {
        if (gesture == null) {
            return;
        }
        dragged |= Math.abs(e.getY() - pressedY) >= DRAGGED;
        at += (lastY - e.getY()) * stopsPerPixel() * (e.isShiftDown() ? FINE : 1);
        lastY = e.getY();
        double to = Math.clamp(at, -range, range);
        hand.move(darkens && to <= -range ? Double.NEGATIVE_INFINITY : Math.rint(to * GRAIN) / GRAIN, gesture);
        e.consume();
    }

    private void release() {
        if (gesture != null) {
            gesture = null;
            hand.end();
        }
    }

    private void key(KeyEvent e) {
        double by = switch (e.getCode()) {
            case UP -> e.isShiftDown() ? KEY * FINE : KEY;
            case DOWN -> e.isShiftDown() ? -KEY * FINE : -KEY;
            case PAGE_UP -> 1;
            case PAGE_DOWN -> -1;
            default -> 0;
        };
        if (by != 0 && gesture == null) {
            double now = Double.isInfinite(stops.get()) ? -range : stops.get();
            hand.move(Math.rint((now + by) * GRAIN) / GRAIN, null);
            e.consume();
        } else if (e.getCode() == KeyCode.ESCAPE && gesture != null) {
            hand.move(from, gesture);
            release();
            e.consume();
        }
    }

    @Override
    public Object queryAccessibleAttribute(AccessibleAttribute attribute, Object... parameters) {
        return switch (attribute) {
            case VALUE -> Math.max(stops.get(), -range);
            case MIN_VALUE -> -range;
            case MAX_VALUE -> range;
            default -> super.queryAccessibleAttribute(attribute, parameters);
        };
    }

    @Override
    protected void layoutChildren() {
        double middle = getWidth() / 2;
        slot.resizeRelocate(middle - 2, CAP / 2, 4, getHeight() - CAP);
        zero.resizeRelocate(middle - 9, Math.rint(place(0)), 18, 1);
        cap.resizeRelocate(middle - 13, Math.rint(place(stops.get()) - CAP / 2), 26, CAP);
    }
}
