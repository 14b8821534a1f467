package lightning.editor.window.timeline;

import java.util.concurrent.Executor;
import java.util.function.BiConsumer;
import lightning.editor.document.EditorState;
import lightning.editor.window.model.SceneEditor;
import lightning.render.image.Film;
import lightning.scene.Scene;
import lightning.shot.FrameState;

/** Shows a frame that the artist goes to in the large picture as another machine has it, while this one makes it. On the window's thread. */
final class RemoteFramePreview {
    private final SceneEditor editor;
    private final Executor windowExecutor;
    private final BiConsumer<Film, Scene> display;
    private int frame = -1;
    /** The scene of the frame gone to, until its picture is there; null then. */
    private volatile Scene pendingScene;
    private Scene requestedScene;

    /**
     * @param windowExecutor runs tasks in turn on the window's thread
     * @param display   gets the film of a scene, on the window's thread
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
