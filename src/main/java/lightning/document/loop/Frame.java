package lightning.document.loop;

import lightning.render.image.Film;
import lightning.render.measure.AccuracyGuarantee;
import lightning.render.relight.UpdateResult;
import lightning.render.shading.IndirectLight;
import lightning.render.shading.RenderedScenes;
import lightning.render.trace.Geometry;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.VisibleState;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/**
 * Finished image of an update.
 *
 * @param film          full image
 * @param displayed     image as displayed: the film itself unless the display mode differs
 * @param displayMode   view of {@code displayed}
 * @param scene         scene of the film
 * @param mirroredScene scene of its reflections and transparency: an older one if reflections are stale (paper §4.8)
 * @param update        update that rendered it
 * @param geometry      primitives and BVH of the update
 * @param indirect      indirect light of the scene; null if it has none
 * @param step          step of the scene's rendering that it is the result of
 * @param isFinished    whether it has all anti-aliasing samples; otherwise one sample per pixel center
 */
public record Frame(Film film, Film displayed, DisplayMode displayMode, Scene scene, Scene mirroredScene, UpdateResult update,
        Geometry geometry, @Nullable IndirectLight indirect, Step step, boolean isFinished) {

    /** Step of the rendering of a scene. A step with finer samples adds no other light. */
    public enum Step {
        /** All light at once. */
        ALL_LIGHT,
        /** Direct light alone, since the scene's indirect light follows in a second step. */
        DIRECT_LIGHT,
        /** Indirect light, added to an image of direct light. */
        INDIRECT_LIGHT
    }

    /** Returns whether it shows a scene, but not the scene's indirect light. */
    public boolean showsDirectLightOf(Scene other) {
        return other.picture().indirect().isPresent() && VisibleState.isSame(other.withoutIndirect(), scene);
    }

    /** Returns the accuracy guarantee of the film. */
    public AccuracyGuarantee guarantee() {
        RenderedScenes seenScenes =
                isFinished ? new RenderedScenes(scene, mirroredScene) : new RenderedScenes(centers(scene), centers(mirroredScene));
        return new AccuracyGuarantee(seenScenes, ViewEffects.ALL, update.errorBound());
    }

    /** Returns whether visible reflective and transparent surfaces, if any, show the current scene. */
    public boolean mirrorsAreCurrent() {
        return !guarantee().isStale();
    }

    /** Returns whether the displayed view has reflective or transparent surfaces that show an older scene. */
    public boolean isDisplayStale() {
        return !new RenderedScenes(displayMode.effects().apply(scene), displayMode.effects().apply(mirroredScene)).areReflectionsCurrent();
    }

    private static Scene centers(Scene scene) {
        return scene.withPicture(scene.picture().withSampling(SamplingSettings.DEFAULT));
    }
}
