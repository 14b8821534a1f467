package lightning.app;

import java.util.function.Supplier;
import javafx.scene.layout.Region;
import javafx.stage.Stage;
import javafx.stage.Window;
import javafx.stage.WindowEvent;
import lightning.app.command.UndoKeys;
import lightning.app.contribution.ContributionPane;
import lightning.app.cue.CuePane;
import lightning.app.measure.AccuracyPane;
import lightning.app.measure.EffectsPane;
import lightning.app.measure.ScopesPane;
import lightning.app.mixer.MixerPane;
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
    private Stage scopes;
    private Stage mixer;
    private Stage cues;
    private Stage history;
    private Stage updates;
    private Stage contributions;

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
        editor.setAction(Command.SCOPES, this::scopes);
        editor.setAction(Command.HISTORY_PANEL, this::history);
        editor.setAction(Command.UPDATES_PANEL, this::updates);
        editor.setAction(Command.MIXER, this::mixer);
        editor.setAction(Command.CUES, this::cues);
        editor.setAction(Command.CONTRIBUTIONS, this::contributions);
    }

    /** What each grade of accuracy costs for the edit made last. */
    private void accuracy() {
        if (accuracy == null) {
            var pane = new AccuracyPane(model);
            accuracy = panel("What Accuracy Costs", pane, 860, 760);
            accuracy.setOnHidden(_ -> pane.stop());
        }
        open(accuracy);
    }

    /** What the scene calls for. */
    private void effects() {
        if (effects == null) {
            var pane = new EffectsPane(model);
            effects = panel("Effects", pane, 760, 680);
            effects.setOnHidden(_ -> pane.stop());
        }
        open(effects);
    }

    /** A strip for each light. */
    private void mixer() {
        if (mixer == null) {
            var pane = new MixerPane(model);
            mixer = panel("Light Mixer", pane, 1000, 460);
            mixer.addEventHandler(WindowEvent.WINDOW_SHOWING, _ -> pane.start());
            mixer.setOnHidden(_ -> pane.stop());
        }
        open(mixer);
    }

    /** How the scene was lit before. */
    private void cues() {
        if (cues == null) {
            var pane = new CuePane(model);
            cues = panel("Cues", pane, 820, 640);
            cues.addEventHandler(WindowEvent.WINDOW_SHOWING, _ -> pane.start());
            cues.setOnHidden(_ -> pane.stop());
        }
        open(cues);
    }

    /** Which lights matter. */
    private void contributions() {
        if (contributions == null) {
            var pane = new ContributionPane(model);
            contributions = panel("Which Lights Matter", pane, 680, 480);
            contributions.addEventHandler(WindowEvent.WINDOW_SHOWING, _ -> pane.start());
            contributions.setOnHidden(_ -> pane.stop());
        }
        open(contributions);
    }

    /** How the codes of the picture are spread. */
    private void scopes() {
        if (scopes == null) {
            var pane = new ScopesPane(model);
            scopes = new PanelWindow(owner.get(), "Scopes", pane, 540, 540);
            scopes.addEventHandler(WindowEvent.WINDOW_SHOWING, _ -> pane.start());
            scopes.setOnHidden(_ -> pane.stop());
        }
        open(scopes);
    }

    /** What mouse and keyboard do. */
    private void keys() {
        if (keys == null) {
            keys = panel("Mouse and Keyboard", new KeysPane(model), 880, 720);
        }
        open(keys);
    }

    /** All edits as a list. */
    private void history() {
        if (history == null) {
            var pane = new HistoryPane(model);
            history = panel("Undo History", pane, 380, 560);
            history.addEventHandler(WindowEvent.WINDOW_SHOWING, _ -> pane.setShown(true));
            history.setOnHidden(_ -> pane.setShown(false));
        }
        open(history);
    }

    /** What the last updates did. */
    private void updates() {
        if (updates == null) {
            updates = panel("What This Update Did", new UpdatesPane(model), 1020, 420);
        }
        open(updates);
    }

    /** Undo works in it as in the editor's window. */
    private Stage panel(String title, Region pane, double width, double height) {
        var stage = new PanelWindow(owner.get(), title, pane, width, height);
        UndoKeys.take(stage.getScene().getRoot(), model);
        return stage;
    }

    private static void open(Stage stage) {
        stage.show();
        stage.toFront();
    }

    @Override
    public void close() {
        for (Stage stage : new Stage[] {accuracy, effects, keys, mixer, cues, contributions, history, updates, scopes}) {
            if (stage != null) {
                stage.close();
            }
        }
    }
}
