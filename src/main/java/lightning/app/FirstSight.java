package lightning.app;

import javafx.animation.AnimationTimer;
import javafx.application.Platform;
import lightning.app.command.TableActions;
import lightning.app.model.EditorModel;
import lightning.app.model.Precision;
import lightning.app.model.Preferences;
import lightning.app.model.Speech;
import lightning.app.traced.TracedPane;
import lightning.edit.FileThread;
import lightning.edit.OpenDocument;
import lightning.edit.Recovery;
import lightning.image.DisplayCurve;

/**
 * A document that is being traced, as the artist left the editor, and its picture in a frame: all that is seen while the rest of
 * the editor is made.
 */
final class FirstSight implements AutoCloseable {
    /** How long the rest of the window waits for a picture, nanoseconds. */
    private static final long PATIENCE_NS = 600_000_000;

    private final EditorModel model;
    private final TracedPane traced;
    private final EditorFrame frame;

    FirstSight(EditorFrame frame, OpenDocument document, Preferences preferences, Recovery recovery, FileThread thread) {
        model = new EditorModel(document, recovery, thread);
        model.precisionProperty().set(preferences.choice("precision", Precision.EXACT));
        model.viewProperty().set(model.viewProperty().get().withCurve(preferences.choice("curve", DisplayCurve.SRGB)));
        TableActions.restore(model, preferences);
        model.previewLook().restore(preferences);
        model.keys().restore(preferences);
        model.arrangement().restore(preferences);
        model.machineChoice().restore(preferences);
        model.speechProperty().set(Speech.of(preferences));
        traced = new TracedPane(model);
        this.frame = frame;
        frame.showTraced(traced);
    }

    EditorModel model() {
        return model;
    }

    TracedPane traced() {
        return traced;
    }

    EditorFrame frame() {
        return frame;
    }

    /** Goes on when the picture was drawn, be it a coarse one, or lets wait for long. */
    void whenSeen(Runnable then) {
        new AnimationTimer() {
            private long since;
            private boolean drawn;

            @Override
            public void handle(long now) {
                since = since == 0 ? now : since;
                if (drawn || now - since > PATIENCE_NS) {
                    stop();
                    Platform.runLater(then);
                }
                // It is drawn after this.
                drawn = !traced.isEmpty();
            }
        }.start();
    }

    @Override
    public void close() {
        traced.close();
        model.close();
    }
}
