package lightning.edit;

import lightning.image.Film;
import lightning.relight.Update;
import lightning.scene.Scene;

/**
 * A finished picture.
 *
 * @param film        valid until the second next frame; {@link Film#copy()} keeps it for longer
 * @param scene       what it shows
 * @param mirrored    what its mirrors show: an older scene where reflections are stale (paper §4.8)
 * @param update      how it came about
 * @param fullTraceMs what a full trace of this picture takes, milliseconds: the first pass's time, which keeps the rows
 *                    too, until a verification has measured a trace that keeps nothing
 */
public record Frame(Film film, Scene scene, Scene mirrored, Update update, double fullTraceMs) {
    /** The share of a full trace's time that the update saved, at most 1; negative where it cost more. */
    public double saving() {
        return 1 - update.milliseconds() / fullTraceMs;
    }

    /** Whether the mirrors show the scene itself, as far as a picture can tell. */
    public boolean mirrorsAreCurrent() {
        return VisiblePart.same(scene, mirrored);
    }
}
