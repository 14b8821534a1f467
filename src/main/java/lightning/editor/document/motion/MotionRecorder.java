package lightning.editor.document.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.scene.Light;
import lightning.scene.Limits;

/** Records a shot of a light while it is moved: a key every so many frames of the preview (paper §3.7). */
public final class MotionRecorder {
    private final int every;
    private final List<Light> samples = new ArrayList<>();
    private int frames;

    /** @param every the resolution number, 1…{@value RecordedShot#MAX_EVERY} */
    public MotionRecorder(int every) {
        Limits.range("resolution", every, 1, RecordedShot.MAX_EVERY);
        this.every = every;
    }

    /** The preview drew a frame with the light as it is. The first frame is always recorded, none after the last key that fits. */
    public void frame(Light light) {
        if (frames++ % every == 0 && samples.size() < RecordedShot.MAX_KEYS) {
            samples.add(light);
        }
    }

    /** How many frames were drawn. */
    public int frames() {
        return frames;
    }

    /** What was recorded; empty before the first frame. */
    public Optional<RecordedShot> shot() {
        return samples.isEmpty() ? Optional.empty() : Optional.of(RecordedShot.of(every, samples));
    }
}
