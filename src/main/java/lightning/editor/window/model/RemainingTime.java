package lightning.editor.window.model;

import java.util.ArrayDeque;
import lightning.base.text.Messages;

/**
 * Estimates the remaining time of a task from its progress: by the mean speed so far, or that since half of the progress if it is higher, as
 * programs start slowly.
 */
public final class RemainingTime {
    /** Elapsed time before the first estimate, nanoseconds. */
    private static final long MIN_ELAPSED_NS = 1_000_000_000;
    /** Progress before the first estimate, and for a task that takes long. */
    private static final double MIN_SHARE = 0.1;
    private static final double MIN_LONG_SHARE = 0.04;
    private static final long LONG_NS = 20_000_000_000L;
    /** Progress between two samples. */
    private static final double SAMPLE_SHARE = 0.01;
    private static final double SECOND = 1e9;

    private String task = "";
    private long startNs;
    /** Earlier progress, ascending. */
    private final ArrayDeque<Sample> samples = new ArrayDeque<>();

    private record Sample(double share, long time) {
        /** Returns the remaining time at the speed since this sample, in seconds. */
        double remaining(double nowShare, long now) {
            return (now - time) / SECOND * (1 - nowShare) / (nowShare - share);
        }
    }

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
            samples.clear();
        }
        addSample(share, now);
        long elapsedNs = now - startNs;
        double minShare = elapsedNs < LONG_NS ? MIN_SHARE : MIN_LONG_SHARE;
        return currentTask.isEmpty() || elapsedNs < MIN_ELAPSED_NS || !(share >= minShare) || share >= 1 ? currentTask
                : Messages.tr("{0} · {1} left", currentTask, text(remaining(share, now)));
    }

    private void addSample(double share, long now) {
        while (!samples.isEmpty() && samples.getLast().share > share) {
            samples.removeLast();
        }
        if (share > 0 && (samples.isEmpty() || share >= samples.getLast().share + SAMPLE_SHARE)) {
            samples.addLast(new Sample(share, now));
        }
    }

    private double remaining(double share, long now) {
        double mean = new Sample(0, startNs).remaining(share, now);
        return samples.stream().takeWhile(sample -> sample.share <= share / 2).reduce((_, last) -> last)
                .map(half -> Math.min(mean, half.remaining(share, now))).orElse(mean);
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
