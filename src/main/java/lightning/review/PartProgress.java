package lightning.review;

import lightning.base.work.Progress;

/**
 * Progress of one of several parts of a task, each with its own count.
 *
 * @param index parts that are finished
 * @param count all parts
 */
record PartProgress(Progress whole, int index, int count) implements Progress {
    private static final int STEPS = 1000;

    @Override
    public void report(int done, int total) {
        whole.report(index * STEPS + (int) ((long) STEPS * done / Math.max(1, total)), count * STEPS);
    }

    @Override
    public boolean isCanceled() {
        return whole.isCanceled();
    }
}
