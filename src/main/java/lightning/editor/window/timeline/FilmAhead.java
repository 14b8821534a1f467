package lightning.editor.window.timeline;

import java.util.concurrent.Executor;
import java.util.function.BiConsumer;
import lightning.editor.document.Situation;
import lightning.editor.window.model.SceneEditor;
import lightning.render.image.Film;
import lightning.scene.Scene;
import lightning.shot.FrameState;

/** Shows a frame that the artist goes to in the large picture as another machine has it, while this one makes it. On the window's thread. */
final class FilmAhead {
    private final SceneEditor editor;
    private final Executor window;
    private final BiConsumer<Film, Scene> show;
    private int frame = -1;
    /** The scene of the frame gone to, until its picture is there; null then. */
    private volatile Scene awaited;
    private Scene asked;

    /**
     * @param window runs tasks in turn on the window's thread
     * @param show   gets the film of a scene, on the window's thread
     */
    FilmAhead(SceneEditor editor, Executor window, BiConsumer<Film, Scene> show) {
        this.editor = editor;
        this.window = window;
        this.show = show;
    }

    void follow(Situation now, FilmStrip strip) {
        int to = now.moment().orElseThrow().frame();
        Scene inWork = now.inWork().orElse(null);
        if (to != frame) {
            frame = to;
            awaited = inWork;
        }
        if (inWork != awaited || inWork != editor.document().scene()) {
            awaited = null;
        }
        if (awaited != null && awaited != asked && strip.frames().machines().isPresent() && strip.state(to) == FrameState.CURRENT) {
            Scene scene = awaited;
            asked = scene;
            strip.fetch(to, () -> awaited == scene, film -> window.execute(() -> show.accept(film, scene)));
        }
    }
}
