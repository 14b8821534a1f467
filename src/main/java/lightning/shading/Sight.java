package lightning.shading;

import lightning.scene.Scene;

/**
 * What a picture shows whose mirrors are updated on demand (paper §4.8).
 *
 * @param scene    what the eye sees
 * @param mirrored what is seen in mirrors: a scene that may differ in lights, world and materials
 */
public record Sight(Scene scene, Scene mirrored) {
    /** Both the same. */
    public static Sight of(Scene scene) {
        return new Sight(scene, scene);
    }
}
