package lightning.editor.document;

import java.util.Optional;
import lightning.scene.shot.Key;
import lightning.scene.shot.Shot;

/**
 * The frame of a shot that is shown.
 *
 * @param frame from the shot's first to its last
 */
public record Moment(Shot shot, int frame) {
    /** The frame of the nearest key before this one, or behind it, among the shot's frames; empty where there is none. */
    public Optional<Integer> nearestKey(boolean back) {
        return shot.tracks().stream().flatMap(t -> t.keys().stream()).map(Key::frame)
                .filter(f -> f >= shot.first() && f <= shot.last() && (back ? f < frame : f > frame))
                .reduce((a, b) -> back ? Math.max(a, b) : Math.min(a, b));
    }
}
