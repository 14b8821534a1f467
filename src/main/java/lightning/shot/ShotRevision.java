package lightning.shot;

import lightning.scene.Scene;
import lightning.scene.shot.Shot;

/**
 * What all frames shall show: a scene, and the keys that make each frame's scene of it. It is all that must travel to where frames
 * are held.
 *
 * @param shot one that {@link Shot#check} takes for the scene
 */
public record ShotRevision(Scene scene, Shot shot) {
    /**
     * The scene of a frame.
     *
     * @throws IllegalArgumentException as {@link Shot#sceneAt}
     */
    public Scene sceneAt(int frame) {
        return shot.sceneAt(scene, frame);
    }
}
