package lightning.format.gltf;

import java.util.Collection;
import java.util.List;

/**
 * Frames of an animation, whose keys have times in seconds. Frame 0 is at time 0.
 *
 * @param rate frames per second
 */
record AnimationClock(double rate) {
    /** Usual rates; the first one at whose frames all keys are. */
    private static final List<Double> RATES = List.of(24.0, 25.0, 30.0, 60.0);
    /** Distance from a frame up to which a key counts as at it; times in files are rounded to float. */
    private static final double TOLERANCE = 1e-3;
    /** Rounding of a time to float and of its sum of frames, as a share. */
    private static final double ROUNDING = 0x1p-22;
    private static final double MAX_TOLERANCE = 0.05;

    /** Returns the frames of the usual rate at which all times are; those of the first rate if there is none. */
    static AnimationClock of(Collection<float[]> times) {
        return RATES.stream().map(AnimationClock::new).filter(clock -> times.stream().allMatch(clock::hasFrames)).findFirst()
                .orElseGet(() -> new AnimationClock(RATES.getFirst()));
    }

    private boolean hasFrames(float[] times) {
        for (float time : times) {
            if (frame(time) != Math.rint(frame(time))) {
                return false;
            }
        }
        return true;
    }

    /** Returns the frame at a time, whole if it is near one. */
    double frame(double seconds) {
        double frame = seconds * rate;
        double nearest = Math.rint(frame);
        return Math.abs(frame - nearest) <= Math.min(TOLERANCE + ROUNDING * frame, MAX_TOLERANCE) ? nearest : frame;
    }

    /** Returns the frames at times. */
    double[] frames(float[] times) {
        double[] frames = new double[times.length];
        for (int i = 0; i < frames.length; i++) {
            frames[i] = frame(times[i]);
        }
        return frames;
    }
}
