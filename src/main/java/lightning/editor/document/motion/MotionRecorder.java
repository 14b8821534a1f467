package lightning.editor.document.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.scene.Light;
import lightning.scene.SceneLimits;

/** Records a shot of a light while it is moved: a key every so many frames of the preview (paper §3.7). */
public final class MotionRecorder {
    private final int interval;
    private final List<Light> samples = new ArrayList<>();
    private int frameCount;

    /** @param interval the resolution number, 1…{@value RecordedShot#MAX_INTERVAL} */
    public MotionRecorder(int interval) {
        SceneLimits.checkRange("resolution", interval, 1, RecordedShot.MAX_INTERVAL);
        this.interval = interval;
    }

    /** The preview drew a frame with the light as it is. The first frame is always recorded, none after the last key that fits. */
    public void recordFrame(Light light) {
        if (frameCount++ % interval == 0 && samples.size() < RecordedShot.MAX_KEYS) {
            samples.add(light);
        }
    }

    /** How many frames were drawn. */
    public int frameCount() {
        return frameCount;
    }

    /** What was recorded; empty before the first frame. */
    public Optional<RecordedShot> recordedShot() {
        return samples.isEmpty() ? Optional.empty() : Optional.of(RecordedShot.of(interval, samples));
    }
}
