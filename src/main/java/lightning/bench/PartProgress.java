package lightning.bench;

import lightning.base.work.Progress;

/**
 * The progress of a part, as a share of the whole.
 *
 * @param whole   hears thousandths of the whole
 * @param from    share of the whole that is done before the part, 0…1
 * @param share   the part's own, 0…1
 */
record PartProgress(Progress whole, double from, double share) implements Progress {
    private static final int THOUSANDTHS = 1000;

    @Override
    public void report(int done, int total) {
        whole.report((int) (THOUSANDTHS * (from + share * done / Math.max(total, 1))), THOUSANDTHS);
    }

    @Override
    public boolean isCanceled() {
        return whole.isCanceled();
    }
}
