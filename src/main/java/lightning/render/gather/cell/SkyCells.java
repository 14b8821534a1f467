package lightning.render.gather.cell;

/** Small cells of directions, for reflections of the environment: those of {@link DirectionCells}, divided. */
public final class SkyCells {
    private static final int SIDE = 128;
    private static final int HALF = SIDE * SIDE;
    /** Number of cells. */
    public static final int COUNT = 2 * HALF;

    private SkyCells() {}

    /**
     * Returns the cell of a direction, 0 … {@link #COUNT} − 1.
     *
     * @param x direction of any length but 0, with {@code y} upward and {@code z}
     */
    public static int of(double x, double y, double z) {
        return DirectionCells.of(x, y, z, SIDE);
    }

    /** Writes the unit direction at the center of a cell: x, y, z. */
    public static void writeCenter(int cell, double[] to) {
        double u = (cell % HALF / SIDE + 0.5) * 2 / SIDE - 1;
        double v = (cell % SIDE + 0.5) * 2 / SIDE - 1;
        double x = (u + v) / 2;
        double z = (u - v) / 2;
        double y = Math.max(0, 1 - Math.abs(x) - Math.abs(z));
        double length = Math.sqrt(x * x + y * y + z * z);
        to[0] = x / length;
        to[1] = (cell < HALF ? y : -y) / length;
        to[2] = z / length;
    }
}
