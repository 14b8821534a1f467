package lightning.render.relight.tile;

import lightning.render.shading.TraceCounts;

/** How much was done, over all threads; see {@link lightning.render.relight.Update}. */
public record Tally(long rowsTouched, long rowsComposed, long bytesMoved, TraceCounts rays) {
    public static final Tally NONE = new Tally(0, 0, 0, TraceCounts.NONE);

    public Tally plus(Tally o) {
        return new Tally(rowsTouched + o.rowsTouched, rowsComposed + o.rowsComposed, bytesMoved + o.bytesMoved, rays.plus(o.rays));
    }
}
