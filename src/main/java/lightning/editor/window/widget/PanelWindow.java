package lightning.editor.window.widget;

import javafx.geometry.Rectangle2D;
import javafx.scene.Scene;
import javafx.scene.control.MenuButton;
import javafx.scene.control.ScrollPane;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.stage.Screen;
import javafx.stage.Stage;
import javafx.stage.Window;
import javafx.stage.WindowEvent;

/** Non-modal window of a panel; Escape closes it. */
public class PanelWindow extends Stage {
    /** Distance from the corner of the editor's window, pixels. */
    private static final double MARGIN = 16;
    /** Distance from the lower edge of the editor's window, pixels: its messages stay visible. */
    private static final double BOTTOM_MARGIN = 40;

    private final Region pane;

    /**
     * @param width  pixels
     * @param height  pixels
     */
    public PanelWindow(Window owner, String title, Region pane, double width, double height) {
        this.pane = pane;
        initOwner(owner);
        setTitle(title);
        // Small screens scroll the content. The root must not be a control, which would lack part of the theme.
        var scroll = new ScrollPane(pane);
        scroll.getStyleClass().add("edge-to-edge");
        scroll.setFitToWidth(true);
        scroll.setFitToHeight(true);
        Rectangle2D screen = Screen.getPrimary().getVisualBounds();
        Scene content = ColorTheme.scene(new StackPane(scroll), Math.min(width, screen.getWidth()), Math.min(height, screen.getHeight()));
        content.addEventHandler(KeyEvent.KEY_PRESSED, this::closeOnEscape);
        content.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            // A menu button consumes Escape although its menu is closed.
            if (event.getTarget() instanceof MenuButton button && !button.isShowing()) {
                closeOnEscape(event);
            }
        });
        setScene(content);
        // The theme may have changed while the window was closed.
        setOnShowing(_ -> ColorTheme.style(content));
        setOnShown(_ -> {
            // Covers the properties, so that the traced picture stays visible.
            setX(Math.max(owner.getX(), owner.getX() + owner.getWidth() - getWidth() - MARGIN));
            setY(Math.max(owner.getY(), owner.getY() + owner.getHeight() - getHeight() - BOTTOM_MARGIN));
            WindowPlacement.fit(this);
        });
    }

    private void closeOnEscape(KeyEvent event) {
        if (event.getCode() == KeyCode.ESCAPE) {
            fireEvent(new WindowEvent(this, WindowEvent.WINDOW_CLOSE_REQUEST));
            event.consume();
        }
    }

    /** Returns the content. */
    public Region pane() {
        return pane;
    }
}
