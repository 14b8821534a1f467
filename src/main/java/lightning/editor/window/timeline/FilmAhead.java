package lightning.editor.window.timeline;

import java.util.function.BiConsumer;
import lightning.editor.document.Situation;
import lightning.editor.window.model.EditorModel;
import lightning.render.image.Film;
import lightning.scene.Scene;
import lightning.shot.FrameState;

/** Shows a frame that the artist goes to in the large picture as another machine has it, while this one makes it. On the window's thread. */
final class FilmAhead {
    private final EditorModel model;
    private final BiConsumer<Film, Scene> show;
    private int frame = -1;
    /** The scene of the frame gone to, until its picture is there; null then. */
    private volatile Scene awaited;
    private Scene asked;

    /** @param show gets the film of a scene, on the window's thread */
    FilmAhead(EditorModel model, BiConsumer<Film, Scene> show) {
        this.model = model;
        this.show = show;
    }

    void follow(Situation now, FilmStrip strip) {
        int to = now.moment().orElseThrow().frame();
        Scene inWork = now.inWork().orElse(null);
        if (to != frame) {
            frame = to;
            awaited = inWork;
        }
        if (inWork != awaited || inWork != model.document().scene()) {
            awaited = null;
        }
        if (awaited != null && awaited != asked && strip.machines().isPresent() && strip.state(to) == FrameState.CURRENT) {
            Scene scene = awaited;
            asked = scene;
            strip.fetch(to, () -> awaited == scene, film -> model.window().execute(() -> show.accept(film, scene)));
        }
    }
}
