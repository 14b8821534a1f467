package lightning.bench.accuracy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.measure.InterleavedTimer;

/** Memory bandwidth by the triad {@code a[i] = b[i] + s·c[i]} (McCalpin, STREAM, 1995). */
public final class MemoryBandwidth {
    /** Number of floats per array and thread, far beyond cache sizes. */
    private static final int FLOATS = 1 << 24;
    /** Number of triads, enough to include an undisturbed one. */
    public static final int REPETITIONS = 7;
    private static final int ARRAYS = 3;

    private MemoryBandwidth() {}

    /** Returns the bytes that all threads together read and write per millisecond, the best of a few triads. */
    static double bytesPerMs(WorkerPool workers) {
        return bytesPerMs(triad(workers, REPETITIONS));
    }

    /** Returns the best of some samples in bytes per millisecond, a lower bound of the machine's capability. */
    private static double bytesPerMs(List<Double> samples) {
        return samples.stream().mapToDouble(d -> d).max().orElseThrow();
    }

    /**
     * Runs triads.
     *
     * @param repetitions number of triads, ≥ 1
     * @return bytes read and written per millisecond by all threads together, a value per triad
     */
    public static List<Double> triad(WorkerPool workers, int repetitions) {
        float[][][] arrays = new float[workers.count()][ARRAYS][FLOATS];
        // Pages that were never written may share physical memory.
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
