package lightning.editor.window.widget;

import javafx.geometry.Rectangle2D;
import javafx.scene.Scene;
import javafx.scene.control.ScrollPane;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.stage.Screen;
import javafx.stage.Stage;
import javafx.stage.Window;

/** A window beside the editor's, which stays in use; Escape closes it. */
public class PanelWindow extends Stage {
    /** From the corner of the editor's window, pixels. */
    private static final double MARGIN = 16;

    /** @param width pixels; likewise {@code height} */
    public PanelWindow(Window owner, String title, Region pane, double width, double height) {
        initOwner(owner);
        setTitle(title);
        // On a small screen the content is scrolled and never squeezed. A control as the root would not wear all of the theme.
        var scroll = new ScrollPane(pane);
        scroll.getStyleClass().add("edge-to-edge");
        scroll.setFitToWidth(true);
        scroll.setFitToHeight(true);
        Rectangle2D screen = Screen.getPrimary().getVisualBounds();
        Scene content = ColorTheme.scene(new StackPane(scroll), Math.min(width, screen.getWidth()), Math.min(height, screen.getHeight()));
        content.addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                close();
                event.consume();
            }
        });
        setScene(content);
        // The theme may have changed while it was closed.
        setOnShowing(_ -> ColorTheme.style(content));
        setOnShown(_ -> {
            // Over the properties, so that the traced picture can be seen.
            setX(Math.max(owner.getX(), owner.getX() + owner.getWidth() - getWidth() - MARGIN));
            setY(Math.max(owner.getY(), owner.getY() + owner.getHeight() - getHeight() - MARGIN));
            WindowPlacement.fit(this);
        });
    }
}
