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
import org.jspecify.annotations.Nullable;

/**
 * Fader in stops on a {@link FaderScale}. A drag moves it, ten times finer with Shift; Escape cancels the drag. A double-click sets 0 stops. The up and down keys
 * move it by 0.1 stops, or 0.01 with Shift; Page Up and Page Down by one stop. Its lower end can mean no light.
 */
final class Fader extends Region {
    private static final double CAP_HEIGHT = 16;
    private static final double FINE_FACTOR = 0.1;
    private static final double KEY_STEP = 0.1;
    /** Minimum distance of a drag from the press, pixels. Ignores small movements during a double-click. */
    private static final double DRAG_THRESHOLD = 3;
    /** Resolution of a drag: hundredths of a stop. */
    private static final double STEPS_PER_STOP = 100;

    private final double range;
    private final FaderScale scale;
    private final boolean canTurnOff;
    private final Callbacks callbacks;
    private final Region slot = new Region();
    private final Region zeroMark = new Region();
    private final Region cap = new Region();
    private final DoubleProperty stops = new SimpleDoubleProperty();
    private @Nullable Object gesture;
    /** True if the last press became a drag: a press soon after it is not a double-click. */
    private boolean isDrag;
    private double pressedY;
    private double startStops;
    /** Position of the drag, which has no rounding, on the scale. */
    private double dragPosition;
    /** Stops at position 0 of the drag: a value beyond the range moves from where it is. */
    private double dragOrigin;
    private double lastY;

    /** Receives the fader's values. */
    interface Callbacks {
        /**
         * Sets a value.
         *
         * @param stops value in stops
         * @param gesture one object for all moves of a drag; null for a single step
         */
        void move(double stops, @Nullable Object gesture);

        /** Starts a drag; the next moves with a gesture belong to it. */
        void startDrag();

        /** Ends the drag. */
        void endDrag();
    }

    /**
     * Creates a fader at 0 stops.
     *
     * @param range maximum distance from 0 in both directions, stops
     * @param canTurnOff true if the lower end means no light
     */
    Fader(String title, double range, boolean canTurnOff, Callbacks callbacks) {
        this.range = range;
        scale = new FaderScale(range);
        this.canTurnOff = canTurnOff;
        this.callbacks = callbacks;
        getStyleClass().add("fader");
        slot.getStyleClass().add("slot");
        zeroMark.getStyleClass().add("zero");
        cap.getStyleClass().add("cap");
        getChildren().addAll(slot, zeroMark, cap);
        getChildren().forEach(part -> part.setMouseTransparent(true));
        setAccessibleRole(AccessibleRole.SLIDER);
        setAccessibleText(title);
        setFocusTraversable(true);
        setCursor(Cursor.V_RESIZE);
        setOnMousePressed(this::press);
        setOnMouseDragged(this::drag);
        setOnMouseReleased(_ -> release());
        addEventHandler(KeyEvent.KEY_PRESSED, this::handleKey);
        stops.subscribe(_ -> requestLayout());
    }

    /** Shows a value in stops; −∞ for no light. */
    void show(double v) {
        stops.set(v);
    }

    /** Returns the shown value, stops. */
    double stops() {
        return stops.get();
    }

    /** Returns the center of the cap for a value in stops, pixels from the top. */
    double capY(double v) {
        return CAP_HEIGHT / 2 + (1 - scale.position(v)) / 2 * length();
    }

    private double length() {
        return getHeight() - CAP_HEIGHT;
    }

    private void press(MouseEvent e) {
        requestFocus();
        if (e.getButton() != MouseButton.PRIMARY) {
            return;
        }
        if (e.getClickCount() == 2 && !isDrag) {
            callbacks.move(0, null);
            return;
        }
        isDrag = false;
        pressedY = e.getY();
        gesture = new Object();
        startStops = stops.get();
        dragOrigin = Double.isFinite(startStops) && Math.abs(startStops) > range ? startStops : 0;
        dragPosition = scale.position(startStops - dragOrigin);
        lastY = e.getY();
        callbacks.startDrag();
        e.consume();
    }

    private void drag(MouseEvent e) {
        if (gesture == null) {
            return;
        }
        isDrag |= Math.abs(e.getY() - pressedY) >= DRAG_THRESHOLD;
        dragPosition += FaderScale.drag(lastY - e.getY(), length()) * (e.isShiftDown() ? FINE_FACTOR : 1);
        lastY = e.getY();
        double newStops = dragOrigin + scale.stops(Math.clamp(dragPosition, -1, 1));
        callbacks.move(
                canTurnOff && dragOrigin == 0 && newStops <= -range ? Double.NEGATIVE_INFINITY
                        : Math.rint(newStops * STEPS_PER_STOP) / STEPS_PER_STOP,
                gesture);
        e.consume();
    }

    private void release() {
        if (gesture != null) {
            gesture = null;
            callbacks.endDrag();
        }
    }

    private void handleKey(KeyEvent e) {
        double step = switch (e.getCode()) {
            case UP -> e.isShiftDown() ? KEY_STEP * FINE_FACTOR : KEY_STEP;
            case DOWN -> e.isShiftDown() ? -KEY_STEP * FINE_FACTOR : -KEY_STEP;
            case PAGE_UP -> 1;
            case PAGE_DOWN -> -1;
            default -> 0;
        };
        if (step != 0 && gesture == null) {
            double now = Double.isInfinite(stops.get()) ? -range : stops.get();
            callbacks.move(Math.rint((now + step) * STEPS_PER_STOP) / STEPS_PER_STOP, null);
            e.consume();
        } else if (e.getCode() == KeyCode.ESCAPE && gesture != null) {
            callbacks.move(startStops, gesture);
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
        slot.resizeRelocate(middle - 2, CAP_HEIGHT / 2, 4, length());
        zeroMark.resizeRelocate(middle - 9, Math.rint(capY(0)), 18, 1);
        cap.resizeRelocate(middle - 13, Math.rint(capY(stops.get()) - CAP_HEIGHT / 2), 26, CAP_HEIGHT);
    }
}
