package lightning.editor.document.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.scene.Light;
import lightning.scene.Limits;

/** Records a motion path while the light is moved: every so many frames of the preview (paper §3.7). */
public final class MotionRecorder {
    private final int every;
    private final List<MotionPath.Key> keys = new ArrayList<>();
    private int frames;

    /** @param every the resolution number, 1…{@value MotionPath#MAX_EVERY} */
    public MotionRecorder(int every) {
        Limits.range("resolution", every, 1, MotionPath.MAX_EVERY);
        this.every = every;
    }

    /** The preview drew a frame with the light as it is; the first frame is always kept, none beyond the longest path. */
    public void frame(Light light) {
        if (frames++ % every == 0 && keys.size() < MotionPath.MAX_KEYS) {
            keys.add(MotionPath.Key.of(light));
        }
    }

    /** How many frames were drawn. */
    public int frames() {
        return frames;
    }

    /** What was recorded; empty before the first frame. */
    public Optional<MotionPath> path() {
        return keys.isEmpty() ? Optional.empty() : Optional.of(new MotionPath(every, keys));
    }
}
