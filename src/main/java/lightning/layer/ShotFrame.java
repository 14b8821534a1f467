package lightning.layer;

import lightning.base.text.RefusalException;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;

/**
 * Frame of a shot that an image shows, with the frames next to it. Shapes keep their names between frames.
 *
 * @param previous scene one frame earlier
 * @param next scene one frame later
 */
public record ShotFrame(FrameTime time, Scene previous, Scene next) {
    /**
     * Returns a frame of a shot. Before the first and after the last keyframe nothing moves. A neighbor whose values are inconsistent, such
     * as a camera at its target, counts as if nothing moved.
     *
     * @param scene scene of the shot without its keyframes
     */
    public static ShotFrame of(Shot shot, Scene scene, int frame) {
        return new ShotFrame(new FrameTime(frame, shot.rate()), neighbor(shot, scene, frame, frame - 1),
                neighbor(shot, scene, frame, frame + 1));
    }

    private static Scene neighbor(Shot shot, Scene scene, int frame, int neighbor) {
        try {
            return shot.sceneAt(scene, neighbor);
        } catch (RefusalException _) {
            return shot.sceneAt(scene, frame);
        }
    }
}
