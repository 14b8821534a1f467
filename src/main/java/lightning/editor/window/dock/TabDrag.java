package lightning.editor.window.dock;

import static java.util.Objects.requireNonNull;

import java.util.Locale;
import javafx.geometry.BoundingBox;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Region;
import lightning.editor.Command;
import lightning.editor.window.model.PanelPlace;
import org.jspecify.annotations.Nullable;

/** Drag of a tab to another dock, or out of the docks into a window of its own. A frame shows where the panel will be. */
public final class TabDrag {
    /** Distance that distinguishes a drag from a click, pixels. */
    private static final double THRESHOLD = 16;
    /** Share of the pictures' area at its left and lower edge that stands for an empty dock. */
    private static final double EDGE = 0.25;
    private static final double WINDOW_WIDTH = 240;
    private static final double WINDOW_HEIGHT = 160;

    private final Node area;
    private final Region frame;
    private final DropCallback drop;
    /** Panel whose tab is pressed. */
    private @Nullable Command pressed;
    private double startX;
    private double startY;
    private boolean isDragging;

    /** Receives the end of a drag. */
    public interface DropCallback {
        /**
         * Moves a panel.
         *
         * @param screenX position of the mouse on the screen, pixels
         */
        void drop(Command panel, PanelPlace place, double screenX, double screenY);
    }

    /**
     * Creates the drag.
     *
     * @param area pictures and docks
     * @param frame unmanaged region above all panes that shows the target
     */
    public TabDrag(Node area, Region frame, DropCallback drop) {
        this.area = area;
        this.frame = frame;
        this.drop = drop;
        frame.setVisible(false);
        frame.setManaged(false);
        frame.setMouseTransparent(true);
        frame.getStyleClass().add("dock-target");
    }

    /** Makes the tabs of a dock draggable. */
    public void attach(DockTabs dock) {
        dock.addEventFilter(MouseEvent.MOUSE_PRESSED, e -> {
            pressed = e.getButton() == MouseButton.PRIMARY ? dock.panelAt(e.getSceneX(), e.getSceneY()).orElse(null) : null;
            startX = e.getSceneX();
            startY = e.getSceneY();
        });
        dock.addEventFilter(MouseEvent.MOUSE_DRAGGED, e -> {
            isDragging |= pressed != null && Math.hypot(e.getSceneX() - startX, e.getSceneY() - startY) > THRESHOLD;
            if (isDragging) {
                show(placeAt(e.getSceneX(), e.getSceneY()), e.getSceneX(), e.getSceneY());
                e.consume();
            }
        });
        dock.addEventFilter(MouseEvent.MOUSE_RELEASED, e -> {
            frame.setVisible(false);
            PanelPlace place = placeAt(e.getSceneX(), e.getSceneY());
            if (isDragging && place != dock.place()) {
                drop.drop(requireNonNull(pressed), place, e.getScreenX(), e.getScreenY());
            }
            isDragging = false;
            pressed = null;
        });
    }

    private PanelPlace placeAt(double x, double y) {
        Bounds bounds = area.localToScene(area.getBoundsInLocal());
        for (PanelPlace dock : PanelPlace.values()) {
            if (dock.isDock() && area.getScene().lookup("#dock-" + dock.name().toLowerCase(Locale.ROOT)) instanceof Node shown
                    && shown.localToScene(shown.getBoundsInLocal()).contains(x, y)) {
                return dock;
            }
        }
        if (!bounds.contains(x, y)) {
            return PanelPlace.WINDOW;
        }
        return y > bounds.getMaxY() - EDGE * bounds.getHeight() ? PanelPlace.BELOW
                : x < bounds.getMinX() + EDGE * bounds.getWidth() ? PanelPlace.LEFT : PanelPlace.WINDOW;
    }

    private void show(PanelPlace place, double x, double y) {
        Bounds all = area.localToScene(area.getBoundsInLocal());
        Bounds target = switch (place) {
            case LEFT -> new BoundingBox(all.getMinX(), all.getMinY(), EDGE * all.getWidth(), all.getHeight());
            case BELOW -> new BoundingBox(all.getMinX(), all.getMaxY() - EDGE * all.getHeight(), all.getWidth(), EDGE * all.getHeight());
            case WINDOW -> new BoundingBox(x, y, WINDOW_WIDTH, WINDOW_HEIGHT);
        };
        Bounds local = frame.getParent().sceneToLocal(target);
        frame.setVisible(true);
        frame.resizeRelocate(local.getMinX(), local.getMinY(), local.getWidth(), local.getHeight());
    }
}
