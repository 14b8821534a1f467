package lightning.app;

import java.util.function.Supplier;
import javafx.stage.Stage;
import javafx.stage.Window;
import lightning.app.measure.AccuracyPane;
import lightning.app.measure.EffectsPane;
import lightning.app.model.EditorModel;
import lightning.app.widget.PanelWindow;
import lightning.edit.Command;

/** The windows beside the editor's, each open at most once. */
final class Panels implements AutoCloseable {
    private final EditorModel model;
    private final Supplier<Window> owner;
    private Stage accuracy;
    private Stage effects;
    private Stage keys;

    /** @param owner the editor's window, once there is one */
    Panels(EditorModel model, Supplier<Window> owner) {
        this.model = model;
        this.owner = owner;
    }

    /** Does the commands that open them. */
    void addTo(EditorModel editor) {
        editor.setAction(Command.ACCURACY_PANEL, this::accuracy);
        editor.setAction(Command.EFFECTS_PANEL, this::effects);
        editor.setAction(Command.KEYS, this::keys);
    }

    /** What each grade of accuracy costs for the edit made last. */
    private void accuracy() {
        if (accuracy == null) {
            var pane = new AccuracyPane(model);
            accuracy = new PanelWindow(owner.get(), "What Accuracy Costs", pane, 860, 760);
            accuracy.setOnHidden(_ -> pane.stop());
        }
        open(accuracy);
    }

    /** What the scene calls for. */
    private void effects() {
        if (effects == null) {
            var pane = new EffectsPane(model);
            effects = new PanelWindow(owner.get(), "Effects", pane, 760, 680);
            effects.setOnHidden(_ -> pane.stop());
        }
        open(effects);
    }

    /** What mouse and keyboard do. */
    private void keys() {
        if (keys == null) {
            keys = new PanelWindow(owner.get(), "Mouse and Keyboard", new KeysPane(), 880, 720);
        }
        open(keys);
    }

    private static void open(Stage stage) {
        stage.show();
        stage.toFront();
    }

    @Override
    public void close() {
        for (Stage stage : new Stage[] {accuracy, effects, keys}) {
            if (stage != null) {
                stage.close();
            }
        }
    }
}
