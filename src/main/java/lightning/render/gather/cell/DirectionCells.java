package lightning.render.gather.cell;

/**
 * Cells of directions: two square grids, one above and one below the horizon, so that no cell contains both sky and ground. A half of the
 * octahedron |x| + |y| + |z| = 1, seen from above, is a square that stands on a corner (Engelhardt and Dachsbacher, Octahedron environment maps,
 * 2008); the grid lies along its sides. A cell has 0.0009 to 0.0045 steradians.
 */
public final class DirectionCells {
    /** Cells along a side of a grid. A point's rays and those of its neighbors are as dense. */
    private static final int SIDE = 48;
    /** Number of cells. */
    public static final int COUNT = 2 * SIDE * SIDE;

    private DirectionCells() {}

    /**
     * Returns the cell of a direction, 0 … {@link #COUNT} − 1.
     *
     * @param x direction of any length but 0, with {@code y} upward and {@code z}
     */
    public static int of(double x, double y, double z) {
        return of(x, y, z, SIDE);
    }

    /** @param side cells along a side of a grid */
    static int of(double x, double y, double z, int side) {
        double sum = Math.abs(x) + Math.abs(y) + Math.abs(z);
        return (y < 0 ? side * side : 0) + line((x + z) / sum, side) * side + line((x - z) / sum, side);
    }

    /** @param place −1…1 */
    private static int line(double place, int side) {
        return Math.min(side - 1, (int) ((place + 1) * 0.5 * side));
    }
}
