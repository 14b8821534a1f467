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

    /** Creates a part that needs another program: its failure becomes a failed measurement. */
    static BenchPart ofProgram(String where, double predictedMs, ResultCollector ledger, Measurement work) {
        return new BenchPart(where, predictedMs, progress -> {
            try {
                work.measure(progress);
            } catch (IOException e) {
                ledger.addUnmeasured(where, e.getMessage());
            }
        });
    }
}
