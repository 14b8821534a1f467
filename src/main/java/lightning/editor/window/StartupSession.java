package lightning.editor.window;

import lightning.document.FileThread;
import lightning.document.OpenDocument;
import lightning.document.RecoveryFolder;
import lightning.document.loop.KeptPictures;
import lightning.editor.window.command.ColorTableActions;
import lightning.editor.window.model.AccuracyMode;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.model.StartupPreview;
import lightning.editor.window.model.UiLanguage;
import lightning.editor.window.model.WorkingSize;
import lightning.editor.window.traced.TracedPane;
import lightning.render.image.ViewTransform;
import lightning.render.relight.SceneView;

/**
 * Document that is being traced with the stored view settings, and the pane of its picture. Shows the picture while the rest of the editor
 * is created.
 */
final class StartupSession implements AutoCloseable {
    /** Maximum time that the rest of the window waits for a picture, nanoseconds. */
    private static final long PICTURE_TIMEOUT_NS = 600_000_000;

    private final EditorModel model;
    private final TracedPane traced;
    private final EditorLayout layout;
    private final StartupPreview preview;

    /**
     * Starts to render the document.
     *
     * @param preview preview of the document's scene, from {@link #startPreview}
     * @param kept    pictures of earlier processes
     */
    StartupSession(EditorLayout layout, OpenDocument document, StartupPreview preview, Preferences preferences, RecoveryFolder recovery,
            FileThread thread, KeptPictures kept) {
        this.preview = preview;
        model = new EditorModel(document, WorkingSize.of(preferences).area(layout.picture().area()), preview, recovery, thread, kept);
        model.accuracyModeProperty().set(preferences.enumValue("precision", AccuracyMode.EXACT).forOtherFile());
        model.editor().liveProperty().set(!preferences.hasValue("live", "false"));
        ColorTableActions.restore(model, preferences);
        model.previewSettings().restore(preferences);
        model.commands().keyBindings().restore(preferences);
        model.layout().restore(preferences);
        model.renderMachines().restore(preferences);
        model.languageProperty().set(UiLanguage.of(preferences));
        traced = new TracedPane(model, layout.picture());
        this.layout = layout;
        layout.showTraced(traced);
    }

    /** Starts the preview of a document's scene with its view. */
    static StartupPreview startPreview(OpenDocument document, Preferences preferences) {
        ViewTransform view = SceneView.of(document.scene());
        // Without its color table the preview would show wrong colors for a moment.
        return ColorTableActions.hasStoredTable(preferences) ? StartupPreview.none(view) : StartupPreview.start(document.scene(), view);
    }

    EditorModel model() {
        return model;
    }

    TracedPane traced() {
        return traced;
    }

    EditorLayout frame() {
        return layout;
    }

    /** Runs the callback when the picture, coarse or final, is painted, or after a timeout. */
    void whenPainted(Runnable callback) {
        PaintCallbacks.afterPaintOf(() -> !traced.isEmpty(), PICTURE_TIMEOUT_NS, callback);
    }

    @Override
    public void close() {
        preview.endStartup();
        traced.close();
        model.close();
    }
}
