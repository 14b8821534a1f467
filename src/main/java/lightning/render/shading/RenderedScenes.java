package lightning.render.shading;

import lightning.scene.Scene;
import lightning.scene.VisibleState;
import lightning.scene.effects.SceneEffects;

/**
 * Scenes shown by a picture whose reflections and refractions are updated on demand (paper §4.8).
 *
 * @param scene    the scene that camera rays see
 * @param mirrored the scene that bounced rays see; may differ in lights, world and materials
 */
public record RenderedScenes(Scene scene, Scene mirrored) {
    /** Returns a pair of the same scene. */
    public static RenderedScenes of(Scene scene) {
        return new RenderedScenes(scene, scene);
    }

    /** Returns whether bounced rays show the current scene: the visible parts are equal, or no ray bounces. */
    public boolean areReflectionsCurrent() {
        return VisibleState.isSame(scene, mirrored) || !SceneEffects.of(scene).spawnsSecondaryRays();
    }
}
