package lightning.bench;

import lightning.base.work.Progress;

/**
 * Progress of a part, scaled to the whole.
 *
 * @param whole receives thousandths of the whole
 * @param from  share of the whole before the part, 0…1
 * @param share share of the part, 0…1
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
