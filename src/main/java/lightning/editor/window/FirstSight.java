package lightning.editor.window;

import lightning.editor.document.FileThread;
import lightning.editor.document.OpenDocument;
import lightning.editor.document.Recovery;
import lightning.editor.window.command.TableActions;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.Glimpse;
import lightning.editor.window.model.Precision;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.model.Speech;
import lightning.editor.window.traced.TracedPane;
import lightning.render.image.DisplayCurve;
import lightning.render.image.ViewTransform;

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

    /** @param seen of the document's scene, as {@link #look} does */
    FirstSight(EditorFrame frame, OpenDocument document, Glimpse seen, Preferences preferences, Recovery recovery,
            FileThread thread) {
        model = new EditorModel(document, seen, recovery, thread);
        model.precisionProperty().set(preferences.choice("precision", Precision.EXACT));
        TableActions.restore(model, preferences);
        model.previewLook().restore(preferences);
        model.commands().keys().restore(preferences);
        model.arrangement().restore(preferences);
        model.machineChoice().restore(preferences);
        model.speechProperty().set(Speech.of(preferences));
        traced = new TracedPane(model, frame.picture());
        this.frame = frame;
        frame.showTraced(traced);
    }

    /** Begins to look at a document's scene, as the artist left the view. */
    static Glimpse look(OpenDocument document, Preferences preferences) {
        ViewTransform view = ViewTransform.DEFAULT.withCurve(preferences.choice("curve", DisplayCurve.SRGB));
        // Without its table the picture would have other colors for a moment.
        return TableActions.isKept(preferences) ? Glimpse.none(view) : Glimpse.begin(document.scene(), view);
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
        Drawn.with(() -> !traced.isEmpty(), PATIENCE_NS, then);
    }

    @Override
    public void close() {
        traced.close();
        model.close();
    }
}
