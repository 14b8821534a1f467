package lightning.render.relight.tile;

import lightning.render.shading.RayCounts;

/** Amount of work over all threads; see {@link lightning.render.relight.UpdateResult}. */
public record WorkCounts(long rowsTouched, long rowsComposed, long bytesMoved, RayCounts rays) {
    public static final WorkCounts NONE = new WorkCounts(0, 0, 0, RayCounts.NONE);

    public WorkCounts plus(WorkCounts o) {
        return new WorkCounts(rowsTouched + o.rowsTouched, rowsComposed + o.rowsComposed, bytesMoved + o.bytesMoved, rays.plus(o.rays));
    }
}
