package lightning.base.work;

import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/** Listener for the progress of a long task, which can also cancel it. Called from any worker thread. */
public interface Progress {
    /** Reports that {@code done} of {@code total} tiles are finished. */
    void report(int done, int total);

    /** Returns whether the task must stop; polled before every tile and between the lights of a tile. */
    boolean isCanceled();

    /**
     * Ends a task that must stop.
     *
     * @param message says at what time, for developers
     * @throws CancellationException if the task must stop
     */
    default void checkCanceled(String message) {
        if (isCanceled()) {
            throw new CancellationException(message);
        }
    }

    /**
     * Reports a finished tile of a full render before the image is complete.
     *
     * @param film red, green and blue, each {@code float[1024]}; not written again, but anti-aliased samples may follow
     */
    default void tileFinished(int tile, float[][] film) {}

    /** Reports rays that were cast since the last report. */
    default void raysCast(long count) {}

    /** Returns the progress of a part of a task: {@code offset} tiles are already finished, {@code total} in all. */
    default Progress subProgress(int offset, int total) {
        Progress parent = this;
        return new Progress() {
            @Override
            public void report(int done, int ofPart) {
                parent.report(offset + done, total);
            }

            @Override
            public boolean isCanceled() {
                return parent.isCanceled();
            }
        };
    }

    /** Returns a progress that only forwards cancellation: for parts of a task that is shown as a whole. */
    default Progress cancellationOnly() {
        return cancellation(this::isCanceled);
    }

    /** Returns a progress that ignores reports and polls {@code canceled} on any worker thread. */
    static Progress cancellation(BooleanSupplier canceled) {
        return new Progress() {
            @Override
            public void report(int done, int total) {}

            @Override
            public boolean isCanceled() {
                return canceled.getAsBoolean();
            }
        };
    }

    /** Ignores reports and never cancels. */
    Progress NONE = cancellation(() -> false);
}
