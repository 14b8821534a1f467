package lightning.app.timeline;

import lightning.app.model.EditorModel;
import lightning.edit.Situation;
import lightning.scene.Scene;
import lightning.shot.FrameState;

/** Shows a frame that the artist goes to in the large picture as another machine has it, while this one makes it. On the window's thread. */
final class FilmAhead {
    private final EditorModel model;
    private int frame = -1;
    /** The scene of the frame gone to, until its picture is there; null then. */
    private Scene awaited;
    private Scene asked;

    FilmAhead(EditorModel model) {
        this.model = model;
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
            strip.fetch(to, film -> model.window().execute(() -> model.showAhead(film, scene)));
        }
    }
}
