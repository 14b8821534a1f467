package lightning.app;

import javafx.scene.Scene;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.stage.Stage;
import javafx.stage.Window;

/** Shows what each level of accuracy costs for the edit made last; the editor beside it stays in use. */
public final class AccuracyWindow extends Stage {
    private static final double WIDTH = 860;
    private static final double HEIGHT = 760;

    public AccuracyWindow(EditorModel model, Window owner) {
        initOwner(owner);
        setTitle("What Accuracy Costs");
        var pane = new AccuracyPane(model);
        var content = new Scene(pane, WIDTH, HEIGHT);
        content.addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                close();
            }
        });
        Looks.dress(content);
        setScene(content);
        setOnHidden(_ -> pane.stop());
    }
}
