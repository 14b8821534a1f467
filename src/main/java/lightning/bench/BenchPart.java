package lightning.bench;

import java.io.IOException;
import lightning.base.work.Progress;

/**
 * Part of a benchmark run.
 *
 * @param where       title for progress and error messages
 * @param predictedMs predicted duration, milliseconds
 */
record BenchPart(String where, double predictedMs, Measurement work) {
    /** Measurement of a part; adds its results to the run's collector itself. */
    @FunctionalInterface
    public interface Measurement {
        /**
         * @throws IOException          if an image cannot be written or another program fails
         * @throws InterruptedException if this thread was interrupted
         */
        void measure(Progress progress) throws IOException, InterruptedException;
    }
}
