package lightning.editor.document;

import java.util.Optional;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.Shot;

/**
 * The frame of a shot that is shown.
 *
 * @param frame from the shot's first to its last
 */
public record ShotFrame(Shot shot, int frame) {
    /** The frame of the nearest key before this one, or behind it, among the shot's frames; empty where there is none. */
    public Optional<Integer> nearestKeyFrame(boolean isBackward) {
        return shot.tracks().stream().flatMap(t -> t.keys().stream()).map(Keyframe::frame)
                .filter(f -> f >= shot.first() && f <= shot.last() && (isBackward ? f < frame : f > frame))
                .reduce((a, b) -> isBackward ? Math.max(a, b) : Math.min(a, b));
    }
}
