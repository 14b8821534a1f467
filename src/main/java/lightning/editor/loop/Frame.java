package lightning.editor.loop;

import lightning.bench.accuracy.AccuracyGuarantee;
import lightning.render.image.Film;
import lightning.render.relight.UpdateResult;
import lightning.render.shading.RenderedScenes;
import lightning.render.trace.Geometry;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;

/**
 * A finished picture.
 *
 * @param film     the picture
 * @param displayed     what is shown of it: the film itself unless the look has it otherwise
 * @param displayMode     what {@code displayed} is
 * @param scene    what the film shows
 * @param mirroredScene what its mirrors and clear surfaces show: an older scene where reflections are stale (paper §4.8)
 * @param update   how it came about
 * @param geometry what its rays met, with the tree that it was traced with
 * @param isFinished whether it has all samples that its scene asks for; else it shows the pixels' centers, without anti-aliasing
 */
public record Frame(Film film, Film displayed, DisplayMode displayMode, Scene scene, Scene mirroredScene, UpdateResult update,
        Geometry geometry,
        boolean isFinished) {
    /** What the film is said to be. */
    public AccuracyGuarantee guarantee() {
        RenderedScenes seenScenes =
                isFinished ? new RenderedScenes(scene, mirroredScene) : new RenderedScenes(centers(scene), centers(mirroredScene));
        return new AccuracyGuarantee(seenScenes, ViewEffects.ALL, update.errorBound());
    }

    /** Whether mirrors and clear surfaces, if there are any, show the scene itself, as far as a picture can tell. */
    public boolean mirrorsAreCurrent() {
        return !guarantee().isStale();
    }

    /** Whether what its look shows has mirrors or clear surfaces that show an older scene. */
    public boolean isDisplayStale() {
        return !new RenderedScenes(displayMode.effects().apply(scene), displayMode.effects().apply(mirroredScene)).areReflectionsCurrent();
    }

    private static Scene centers(Scene scene) {
        return scene.withPicture(scene.picture().withSampling(SamplingSettings.DEFAULT));
    }
}
