package lightning.bench;

import lightning.base.work.Progress;

/**
 * The progress of a part, as a share of the whole.
 *
 * @param whole   hears thousandths of the whole
 * @param from    share of the whole that is done before the part, 0…1
 * @param share   the part's own, 0…1
 */
record Share(Progress whole, double from, double share) implements Progress {
    private static final int THOUSANDTHS = 1000;

    @Override
    public void tiles(int done, int total) {
        whole.tiles((int) (THOUSANDTHS * (from + share * done / Math.max(total, 1))), THOUSANDTHS);
    }

    @Override
    public boolean isCancelled() {
        return whole.isCancelled();
    }
}
