package lightning.editor.window.model;

import lightning.base.text.Messages;

/** Estimates the remaining time of a task from its elapsed time and progress. */
public final class RemainingTime {
    /** Elapsed time before the first estimate, nanoseconds. */
    private static final long MIN_ELAPSED_NS = 1_000_000_000;
    private static final double MIN_SHARE = 0.04;
    private static final double SECOND = 1e9;

    private String task = "";
    private long startNs;

    /**
     * Returns the task's text with its remaining time, for example {@code Tracing · 12 s left}; without the time while the estimate is
     * unreliable.
     *
     * @param currentTask  title of the task; empty for none
     * @param share  progress, 0…1
     * @param now  time in nanoseconds of any monotonic clock
     */
    public String describe(String currentTask, double share, long now) {
        // Work before the first progress, for example tracing coarse images, has another rate.
        if (!currentTask.equals(task) || !(share > 0)) {
            task = currentTask;
            startNs = now;
        }
        long elapsedNs = now - startNs;
        return currentTask.isEmpty() || elapsedNs < MIN_ELAPSED_NS || !(share >= MIN_SHARE) || share >= 1 ? currentTask
                : Messages.tr("{0} · {1} left", currentTask, text(elapsedNs / SECOND * (1 - share) / share));
    }

    /** Formats a duration in seconds, rounded up. */
    private static String text(double seconds) {
        if (seconds < 10) {
            return String.format(Messages.locale(), "%.0f s", Math.max(1, Math.ceil(seconds)));
        }
        return seconds < 90 ? String.format(Messages.locale(), "%.0f s", Math.ceil(seconds / 5) * 5)
                : String.format(Messages.locale(), "%.0f min", Math.ceil(seconds / 60));
    }
}
