package lightning.shot;

import lightning.scene.Scene;
import lightning.scene.shot.Shot;

/**
 * Version of a shot to render: a scene and its keyframes. It contains everything that a remote host needs.
 *
 * @param shot a shot that passes {@link Shot#check} for the scene
 */
public record ShotRevision(Scene scene, Shot shot) {
    /**
     * Returns the scene of a frame.
     *
     * @throws IllegalArgumentException as {@link Shot#sceneAt}
     */
    public Scene sceneAt(int frame) {
        return shot.sceneAt(scene, frame);
    }
}
