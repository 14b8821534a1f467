package lightning.relight;

import lightning.shading.TraceCounts;

/** How much was done, over all threads; see {@link Update}. */
record Work(long rowsTouched, long rowsComposed, TraceCounts rays) {
    static final Work NONE = new Work(0, 0, TraceCounts.NONE);

    static Work of(TileWorker[] threads) {
        Work work = NONE;
        for (TileWorker thread : threads) {
            work = work.plus(new Work(thread.rowsTouched(), thread.rowsComposed(), thread.rays()));
        }
        return work;
    }

    Work plus(Work o) {
        return new Work(rowsTouched + o.rowsTouched, rowsComposed + o.rowsComposed, rays.plus(o.rays));
    }
}
