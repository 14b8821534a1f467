package lightning.document.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.scene.light.Light;
import lightning.scene.value.SceneLimits;

/** Recorder of a moving light: sets a keyframe every few frames of the preview (paper §3.7). */
public final class MotionRecorder {
    private final int interval;
    private final List<Light> samples = new ArrayList<>();
    private int frameCount;

    /** @param interval frames between keyframes, 1…{@value RecordedShot#MAX_INTERVAL} */
    public MotionRecorder(int interval) {
        SceneLimits.checkRange("keyframe interval", interval, 1, RecordedShot.MAX_INTERVAL);
        this.interval = interval;
    }

    /** Records a drawn frame of the preview. Always records the first frame, and none after the maximum number of keyframes. */
    public void recordFrame(Light light) {
        if (frameCount++ % interval == 0 && samples.size() < RecordedShot.MAX_KEYS) {
            samples.add(light);
        }
    }

    /** Returns the number of drawn frames. */
    public int frameCount() {
        return frameCount;
    }

    /** Returns the recorded shot; empty before the first frame. */
    public Optional<RecordedShot> recordedShot() {
        return samples.isEmpty() ? Optional.empty() : Optional.of(RecordedShot.of(interval, samples));
    }
}
