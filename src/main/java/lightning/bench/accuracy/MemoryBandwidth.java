package lightning.bench.accuracy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;

/** How fast this machine's memory is, by the triad {@code a[i] = b[i] + s·c[i]} (McCalpin, STREAM, 1995). */
public final class MemoryBandwidth {
    /** Floats of one array of one thread: far more than caches hold. */
    private static final int FLOATS = 1 << 24;
    /** Enough for one that nothing disturbs. */
    public static final int REPETITIONS = 7;
    private static final int ARRAYS = 3;

    private MemoryBandwidth() {}

    /** Bytes read and written in a millisecond by all threads together; the best of a few triads. */
    static double bytesPerMs(WorkerPool workers) {
        return bytesPerMs(triad(workers, REPETITIONS));
    }

    /** Bytes in a millisecond at the best of some samples: whatever else the machine did, it could do that. */
    private static double bytesPerMs(List<Double> samples) {
        return samples.stream().mapToDouble(d -> d).max().orElseThrow();
    }

    /**
     * Runs triads.
     *
     * @param repetitions how many, ≥ 1
     * @return bytes read and written in a millisecond by all threads together, a value for each triad
     */
    public static List<Double> triad(WorkerPool workers, int repetitions) {
        float[][][] arrays = new float[workers.count()][ARRAYS][FLOATS];
        // Pages that were never written may all be one and the same.
        Arrays.stream(arrays).flatMap(Arrays::stream).forEach(array -> Arrays.fill(array, 1));
        double bytes = (double) ARRAYS * Float.BYTES * FLOATS * workers.count();
        List<Double> samples = new ArrayList<>();
        for (int i = 0; i < repetitions; i++) {
            double ms = InterleavedTimer.timeMs(() -> workers.run(workers.count(),
                    (_, part) -> triad(arrays[part][0], arrays[part][1], arrays[part][2]), Progress.NONE));
            samples.add(bytes / ms);
        }
        return List.copyOf(samples);
    }

    private static void triad(float[] a, float[] b, float[] c) {
        for (int i = 0; i < a.length; i++) {
            a[i] = b[i] + 0.5f * c[i];
        }
    }
}
