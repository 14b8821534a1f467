package lightning.relight.tile;

import lightning.shading.TraceCounts;

/** How much was done, over all threads; see {@link lightning.relight.Update}. */
public record Work(long rowsTouched, long rowsComposed, long bytesMoved, TraceCounts rays) {
    public static final Work NONE = new Work(0, 0, 0, TraceCounts.NONE);

    static Work of(TileWorker[] threads) {
        Work work = NONE;
        for (TileWorker thread : threads) {
            work = work.plus(thread.work());
        }
        return work;
    }

    public Work plus(Work o) {
        return new Work(rowsTouched + o.rowsTouched, rowsComposed + o.rowsComposed, bytesMoved + o.bytesMoved, rays.plus(o.rays));
    }
}
