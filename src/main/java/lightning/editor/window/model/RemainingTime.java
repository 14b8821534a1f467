package lightning.editor.window.model;

import lightning.base.text.Messages;

/** How long a work will still take, from how long it took so far; nothing while that would be a guess. */
public final class RemainingTime {
    /** Before that, nanoseconds, the first tiles tell too little. */
    private static final long MIN_ELAPSED_NS = 1_000_000_000;
    private static final double MIN_SHARE = 0.04;
    private static final double SECOND = 1e9;

    private String task = "";
    private long startNs;

    /**
     * What is told of a work, {@code Tracing · 12 s left}.
     *
     * @param currentTask  the work; empty where there is none
     * @param share how much of it is done, 0…1
     * @param now   nanoseconds of any clock
     */
    public String describe(String currentTask, double share, long now) {
        if (!currentTask.equals(task)) {
            task = currentTask;
            startNs = now;
        }
        long elapsedNs = now - startNs;
        return currentTask.isEmpty() || elapsedNs < MIN_ELAPSED_NS || !(share >= MIN_SHARE) || share >= 1 ? currentTask
                : Messages.tr("{0} · {1} left", currentTask, text(elapsedNs / SECOND * (1 - share) / share));
    }

    /** Seconds as a person would say them: what follows is none. */
    private static String text(double seconds) {
        if (seconds < 10) {
            return String.format(Messages.locale(), "%.0f s", Math.max(1, Math.ceil(seconds)));
        }
        return seconds < 90 ? String.format(Messages.locale(), "%.0f s", Math.ceil(seconds / 5) * 5)
                : String.format(Messages.locale(), "%.0f min", Math.ceil(seconds / 60));
    }
}
