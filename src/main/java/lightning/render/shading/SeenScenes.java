package lightning.render.shading;

import lightning.scene.Scene;
import lightning.scene.VisiblePart;
import lightning.scene.effects.Effects;

/**
 * What a picture shows whose mirrors and clear surfaces are updated on demand (paper §4.8).
 *
 * @param scene    what the eye sees
 * @param mirrored what is seen in mirrors and through clear surfaces: a scene that may differ in lights, world and materials
 */
public record SeenScenes(Scene scene, Scene mirrored) {
    /** Both the same. */
    public static SeenScenes of(Scene scene) {
        return new SeenScenes(scene, scene);
    }

    /** Whether bounced rays show what the eye sees, as far as a picture can tell: equal visible parts, or no ray bounces. */
    public boolean isCurrent() {
        return VisiblePart.same(scene, mirrored) || !Effects.of(scene).bouncesRays();
    }
}
