package lightning.render.trace;

import lightning.render.trace.tree.WayEnd;

/**
 * Where ways to a light lead that is another place, or another direction, for each row of a tile. Reused; not shared between
 * threads.
 */
public final class RowWays {
    /** Lanes may run over the end of a column by less than this. */
    private static final int OVERRUN = 64;

    /** For each row the point, or the direction of any length but 0, up to the next multiple of 16 rows; render space. */
    public final double[] x = new double[RayColumns.MOST + OVERRUN];
    public final double[] y = new double[RayColumns.MOST + OVERRUN];
    public final double[] z = new double[RayColumns.MOST + OVERRUN];
    /** For each row which of the places of a sample is its own, a whole number from 0: kept as lanes choose by it. */
    public final double[] turn = new double[RayColumns.MOST + OVERRUN];
    /** For each row the end of its way; unread where {@link #open}. */
    public final WayEnd[] end = new WayEnd[RayColumns.MOST + OVERRUN];
    /** Whether all ends are {@link WayEnd#isOpen}. */
    public boolean open;
    /** Whether they lead to points, at distance 1. */
    public boolean ends;

    /** Shapes at this distance or beyond do not block. */
    public double limit() {
        return ends ? 1 : Double.POSITIVE_INFINITY;
    }
}
