package lightning.accuracy;

import java.util.Arrays;
import lightning.shading.Progress;
import lightning.shading.Workers;

/** How fast this machine's memory is. */
final class Bandwidth {
    /** Floats that one thread copies: far more than caches hold. */
    private static final int FLOATS = 1 << 24;
    private static final int REPETITIONS = 5;

    private Bandwidth() {}

    /** Bytes read and written in a millisecond by all threads together; the best of a few copies. */
    static double bytesPerMs(Workers workers) {
        float[][] from = new float[workers.count()][FLOATS];
        float[][] to = new float[workers.count()][FLOATS];
        // Pages that were never written may all be one and the same.
        Arrays.stream(from).forEach(array -> Arrays.fill(array, 1));
        double best = 0;
        for (int i = 0; i < REPETITIONS; i++) {
            long start = System.nanoTime();
            workers.run(workers.count(), (_, part) -> System.arraycopy(from[part], 0, to[part], 0, FLOATS), Progress.NONE);
            double ms = (System.nanoTime() - start) / 1e6;
            best = Math.max(best, 2.0 * Float.BYTES * FLOATS * workers.count() / ms);
        }
        return best;
    }
}
