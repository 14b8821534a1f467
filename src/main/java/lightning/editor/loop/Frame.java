package lightning.editor.loop;

import lightning.bench.accuracy.Promise;
import lightning.render.image.Film;
import lightning.render.relight.Update;
import lightning.render.shading.SeenScenes;
import lightning.render.trace.Geometry;
import lightning.scene.Sampling;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;

/**
 * A finished picture.
 *
 * @param film     the picture
 * @param seen     what is shown of it: the film itself unless the look has it otherwise
 * @param look     what {@code seen} is
 * @param scene    what the film shows
 * @param mirrored what its mirrors and clear surfaces show: an older scene where reflections are stale (paper §4.8)
 * @param update   how it came about
 * @param geometry what its rays met, with the tree that it was traced with
 * @param finished whether it has all samples that its scene asks for; else it shows the pixels' centres, without anti-aliasing
 */
public record Frame(Film film, Film seen, Look look, Scene scene, Scene mirrored, Update update, Geometry geometry,
        boolean finished) {
    /** What the film is said to be. */
    public Promise promise() {
        SeenScenes shown = finished ? new SeenScenes(scene, mirrored) : new SeenScenes(centers(scene), centers(mirrored));
        return new Promise(shown, ViewEffects.ALL, update.errorBound());
    }

    /** Whether mirrors and clear surfaces, if there are any, show the scene itself, as far as a picture can tell. */
    public boolean mirrorsAreCurrent() {
        return !promise().isStale();
    }

    /** Whether what its look shows has mirrors or clear surfaces that show an older scene. */
    public boolean looksStale() {
        return !new SeenScenes(look.effects().of(scene), look.effects().of(mirrored)).isCurrent();
    }

    private static Scene centers(Scene scene) {
        return scene.withPicture(scene.picture().withSampling(Sampling.DEFAULT));
    }
}
