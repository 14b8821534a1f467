package lightning.bench;

import java.io.IOException;
import lightning.base.work.Progress;

/**
 * A part of a run.
 *
 * @param where       what is measured, for the one who waits and for complaints
 * @param predictedMs how long it will take, milliseconds
 */
record BenchPart(String where, double predictedMs, Measurement work) {
    /** What is done; it writes into the run's ledger itself. */
    @FunctionalInterface
    public interface Measurement {
        /**
         * @throws IOException if a picture cannot be written or another program fails
         * @throws InterruptedException if this thread was interrupted
         */
        void measure(Progress progress) throws IOException, InterruptedException;
    }
}
