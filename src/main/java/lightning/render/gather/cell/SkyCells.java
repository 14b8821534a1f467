package lightning.render.gather.cell;

/**
 * Cells of directions, for reflections of the environment: those of {@link DirectionCells}, divided, and coarser levels, each with a quarter of
 * the cells of the one before.
 */
public final class SkyCells {
    /** Cells along a side of the grid of the finest level, and of the coarsest. */
    private static final int FINEST = 128;
    private static final int COARSEST = 4;
    /** Number of cells of the finest level, which have the first numbers. */
    public static final int FINEST_COUNT = 2 * FINEST * FINEST;
    /** Number of cells of all levels. */
    public static final int COUNT = first(COARSEST / 2);

    /** Numbers after those of cells: that of the part of the sky above the horizon that a ray stands for, and that of the part below it. */
    public static final int ABOVE = COUNT;
    public static final int BELOW = COUNT + 1;
    public static final int NUMBERS = COUNT + 2;

    /** The four parts of each cell that is not of the finest level. */
    private static final int[] PARTS = parts();

    private SkyCells() {}

    private static int[] parts() {
        int[] parts = new int[4 * (COUNT - FINEST_COUNT)];
        int next = 0;
        for (int side = FINEST / 2; side >= COARSEST; side /= 2) {
            int finer = 2 * side;
            for (int row = 0; row < 2 * side; row++) {
                for (int column = 0; column < side; column++) {
                    for (int number = 0; number < 4; number++) {
                        parts[next++] = first(finer) + (2 * row + number / 2) * finer + 2 * column + number % 2;
                    }
                }
            }
        }
        return parts;
    }

    /** Returns the number of the first cell of the level with a side. */
    private static int first(int side) {
        int first = 0;
        for (int finer = FINEST; finer > side; finer /= 2) {
            first += 2 * finer * finer;
        }
        return first;
    }

    /** Returns the cell of the finest level around a direction of any length but 0, with {@code y} upward. */
    public static int of(double x, double y, double z) {
        return DirectionCells.of(x, y, z, FINEST);
    }

    /**
     * Writes the four cells around a direction whose light is mixed there, and their shares. They are all above the horizon or all below it.
     *
     * @param x direction of any length but 0, with {@code y} upward and {@code z}
     * @param solidAngle about that of a cell, steradians
     */
    public static void mix(double x, double y, double z, double solidAngle, int[] cells, float[] shares) {
        int side = FINEST;
        int first = 0;
        while (side > COARSEST && solidAngle * side * side >= 4 * Math.PI) {
            first += 2 * side * side;
            side /= 2;
        }
        double sum = Math.abs(x) + Math.abs(y) + Math.abs(z);
        double u = Math.clamp(((x + z) / sum + 1) * 0.5 * side - 0.5, 0, side - 1);
        double v = Math.clamp(((x - z) / sum + 1) * 0.5 * side - 0.5, 0, side - 1);
        int row = Math.min((int) u, side - 2);
        int column = Math.min((int) v, side - 2);
        int corner = first + (y < 0 ? side * side : 0) + row * side + column;
        float down = (float) (u - row);
        float right = (float) (v - column);
        for (int i = 0; i < 4; i++) {
            cells[i] = corner + i / 2 * side + i % 2;
            shares[i] = (i / 2 == 0 ? 1 - down : down) * (i % 2 == 0 ? 1 - right : right);
        }
    }

    /** Writes the unit direction at the center of a cell of the finest level: x, y, z. */
    public static void writeCenter(int cell, double[] to) {
        double u = (cell % (FINEST_COUNT / 2) / FINEST + 0.5) * 2 / FINEST - 1;
        double v = (cell % FINEST + 0.5) * 2 / FINEST - 1;
        double x = (u + v) / 2;
        double z = (u - v) / 2;
        double y = Math.max(0, 1 - Math.abs(x) - Math.abs(z));
        double length = Math.sqrt(x * x + y * y + z * z);
        to[0] = x / length;
        to[1] = (cell < FINEST_COUNT / 2 ? y : -y) / length;
        to[2] = z / length;
    }

    /**
     * Returns one of the four cells of the next finer level that a cell consists of.
     *
     * @param cell {@link #FINEST_COUNT} … {@link #COUNT} − 1
     * @param number 0…3
     */
    public static int part(int cell, int number) {
        return PARTS[4 * (cell - FINEST_COUNT) + number];
    }
}
