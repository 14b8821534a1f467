package lightning.app;

import javafx.scene.Parent;
import javafx.scene.Scene;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.stage.Stage;
import javafx.stage.Window;

/** A window beside the editor's, which stays in use; Escape closes it. */
final class PanelWindow extends Stage {
    /** From the corner of the editor's window, pixels. */
    private static final double MARGIN = 16;

    /** @param width pixels; likewise {@code height} */
    PanelWindow(Window owner, String title, Parent pane, double width, double height) {
        initOwner(owner);
        setTitle(title);
        var content = new Scene(pane, width, height);
        content.addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                close();
            }
        });
        Looks.dress(content);
        setScene(content);
        setOnShown(_ -> {
            // Over the properties, so that the traced picture can be seen.
            setX(Math.max(owner.getX(), owner.getX() + owner.getWidth() - getWidth() - MARGIN));
            setY(Math.max(owner.getY(), owner.getY() + owner.getHeight() - getHeight() - MARGIN));
        });
    }
}
