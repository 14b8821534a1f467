package lightning.app;

import java.util.function.Supplier;
import javafx.stage.Stage;
import javafx.stage.Window;

/** The windows beside the editor's, each open at most once. */
final class Panels implements AutoCloseable {
    private final EditorModel model;
    private final Supplier<Window> owner;
    private Stage accuracy;

    /** @param owner the editor's window, once there is one */
    Panels(EditorModel model, Supplier<Window> owner) {
        this.model = model;
        this.owner = owner;
    }

    void accuracy() {
        if (accuracy == null) {
            accuracy = new AccuracyWindow(model, owner.get());
        }
        open(accuracy);
    }

    private static void open(Stage stage) {
        stage.show();
        stage.toFront();
    }

    @Override
    public void close() {
        if (accuracy != null) {
            accuracy.close();
        }
    }
}
