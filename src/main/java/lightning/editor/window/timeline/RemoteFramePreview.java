package lightning.editor.window.timeline;

import java.util.concurrent.Executor;
import java.util.function.BiConsumer;
import lightning.editor.EditorState;
import lightning.editor.window.model.SceneEditor;
import lightning.render.image.Film;
import lightning.scene.Scene;
import lightning.shot.FrameState;
import org.jspecify.annotations.Nullable;

/**
 * Shows the current frame in the main picture as rendered on another machine, until this machine has rendered it. Confined to the window's
 * thread.
 */
final class RemoteFramePreview {
    private final SceneEditor editor;
    private final Executor windowExecutor;
    private final BiConsumer<Film, Scene> display;
    private int frame = -1;
    /** Scene of the current frame until its picture is ready; then null. */
    private volatile @Nullable Scene pendingScene;
    private @Nullable Scene requestedScene;

    /**
     * Creates a preview without a frame.
     *
     * @param windowExecutor runs tasks in order on the window's thread
     * @param display receives a scene's film on the window's thread
     */
    RemoteFramePreview(SceneEditor editor, Executor windowExecutor, BiConsumer<Film, Scene> display) {
        this.editor = editor;
        this.windowExecutor = windowExecutor;
        this.display = display;
    }

    void update(EditorState state, FilmStrip strip) {
        int targetFrame = state.shotFrame().orElseThrow().frame();
        Scene sceneInProgress = state.sceneInProgress().orElse(null);
        if (targetFrame != frame) {
            frame = targetFrame;
            pendingScene = sceneInProgress;
        }
        if (sceneInProgress != pendingScene || sceneInProgress != editor.document().scene()) {
            pendingScene = null;
        }
        if (pendingScene != null && pendingScene != requestedScene && strip.frames().machineCount().isPresent()
                && strip.state(targetFrame) == FrameState.CURRENT) {
            Scene scene = pendingScene;
            requestedScene = scene;
            strip.fetch(targetFrame, () -> pendingScene == scene, film -> windowExecutor.execute(() -> display.accept(film, scene)));
        }
    }
}
