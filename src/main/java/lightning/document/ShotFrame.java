package lightning.document;

import java.util.Optional;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.Shot;

/**
 * Displayed frame of a shot.
 *
 * @param frame frame number, between the shot's first and last
 */
public record ShotFrame(Shot shot, int frame) {
    /** Returns the nearest frame with a keyframe before or after this one, within the shot; empty if none. */
    public Optional<Integer> nearestKeyFrame(boolean isBackward) {
        return shot.tracks().stream().flatMap(t -> t.keys().stream()).map(Keyframe::frame)
                .filter(f -> f >= shot.first() && f <= shot.last() && (isBackward ? f < frame : f > frame))
                .reduce((a, b) -> isBackward ? Math.max(a, b) : Math.min(a, b));
    }
}
