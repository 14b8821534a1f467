package lightning.render.shading;

import lightning.scene.Scene;
import lightning.scene.VisibleState;
import lightning.scene.effects.SceneEffects;

/**
 * What a picture shows whose mirrors and clear surfaces are updated on demand (paper §4.8).
 *
 * @param scene    what the eye sees
 * @param mirrored what is seen in mirrors and through clear surfaces: a scene that may differ in lights, world and materials
 */
public record RenderedScenes(Scene scene, Scene mirrored) {
    /** Both the same. */
    public static RenderedScenes of(Scene scene) {
        return new RenderedScenes(scene, scene);
    }

    /** Whether bounced rays show what the eye sees, as far as a picture can tell: equal visible parts, or no ray bounces. */
    public boolean areReflectionsCurrent() {
        return VisibleState.isSame(scene, mirrored) || !SceneEffects.of(scene).spawnsSecondaryRays();
    }
}
