package lightning.editor.window.dock;

import java.util.function.DoubleUnaryOperator;
import javafx.application.Platform;
import javafx.beans.property.DoubleProperty;
import javafx.beans.value.ObservableDoubleValue;
import javafx.geometry.Orientation;
import javafx.scene.Node;
import javafx.scene.control.SplitPane;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Region;

/**
 * Place of a dock next to the pictures, in a split pane with two items. The dock keeps its size in pixels, but never takes more than a
 * share of the split pane, so that the pictures stay visible in a small window.
 */
public final class DockSlot {
    private static final double MAX_SHARE = 0.45;
    /** Difference of sizes that is no change by the user, pixels. */
    private static final double TOLERANCE = 2;

    private static final double DIVIDER_WIDTH = 4;

    private final SplitPane split;
    private final Region dock;
    private final int index;
    private final DoubleProperty size;
    private final DoubleUnaryOperator defaultSize;
    /** Size to which the dock was last set, pixels. */
    private double placedSize;

    /**
     * Creates an empty place.
     *
     * @param split contains the pictures
     * @param index 0 for a dock before the pictures, 1 after them
     * @param size size chosen by the user, pixels; 0 for the default
     * @param defaultSize pixels, of the split pane's size
     */
    public DockSlot(SplitPane split, Region dock, int index, DoubleProperty size, DoubleUnaryOperator defaultSize) {
        this.split = split;
        this.dock = dock;
        this.index = index;
        this.size = size;
        this.defaultSize = defaultSize;
        SplitPane.setResizableWithParent(dock, false);
        extent(split).subscribe(_ -> placeNowAndAfterLayout());
        size.subscribe(_ -> place());
        split.addEventHandler(MouseEvent.MOUSE_RELEASED, e -> {
            if (e.getTarget() instanceof Node target && target.getStyleClass().contains("split-pane-divider")) {
                remember();
            }
        });
    }

    private ObservableDoubleValue extent(Region region) {
        return split.getOrientation() == Orientation.VERTICAL ? region.heightProperty() : region.widthProperty();
    }

    /**
     * Returns the size of a dock, pixels.
     *
     * @param total  size of the split pane, pixels
     * @param chosen size chosen by the user, pixels; 0 for the default
     * @param defaultSize pixels
     */
    public static double size(double total, double chosen, double defaultSize) {
        return Math.rint(Math.min(total * MAX_SHARE, chosen > 0 ? chosen : defaultSize));
    }

    private boolean isShown() {
        return split.getItems().contains(dock);
    }

    /** Adds the dock to the window, or removes it. */
    public void setShown(boolean shown) {
        if (shown && !isShown()) {
            // Without this layout pass, the split pane would give the dock only its minimum size.
            Node root = split.getScene() == null ? split : split.getScene().getRoot();
            root.applyCss();
            split.layout();
            split.getItems().add(index, dock);
            placeNowAndAfterLayout();
        } else if (!shown && isShown()) {
            remember();
            split.getItems().remove(dock);
        }
    }

    /** Stores the size if the user has changed it. */
    private void remember() {
        double now = extent(dock).get();
        if (now > 0 && isShown() && Math.abs(now - placedSize) > TOLERANCE) {
            size.set(now);
        }
    }

    /** A layout after a change of the window's size keeps the old sizes, whatever the divider's position. */
    private void placeNowAndAfterLayout() {
        place();
        Platform.runLater(this::place);
    }

    private void place() {
        double total = extent(split).get();
        if (total > 0 && isShown()) {
            placedSize = size(total, size.get(), defaultSize.applyAsDouble(total));
            double share = (placedSize + DIVIDER_WIDTH / 2) / total;
            split.setDividerPositions(index == 0 ? share : 1 - share);
        }
    }
}
