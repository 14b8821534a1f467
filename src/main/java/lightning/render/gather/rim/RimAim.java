package lightning.render.gather.rim;

/**
 * Directions of the rays that a point casts in addition, through the cells of its grid of directions that contain the rim of an opening
 * ({@link RimCells}). The rays of such a cell pass different parts of it, and stand for the one ray that passes it otherwise.
 */
public final class RimAim {
    /**
     * Changes from the part of a cell that a point's own ray passes to that of the first, second … ray. Bits 0 and 1 are the column, bits 2
     * and 3 the line. The first 2, 4 and 8 rays lie as evenly as all 16.
     */
    private static final int[] TURNS = {0, 0b1010, 0b0010, 0b1000, 0b0101, 0b1111, 0b0111, 0b1101, 0b0001, 0b1011, 0b0011, 0b1001, 0b0100,
        0b1110, 0b0110, 0b1100};

    private RimAim() {}

    /**
     * Returns the rays of each cell with a rim, with the point's own one: the largest power of two, up to 16, with which the additional ones
     * are at most half as many as the point has rays. 1 if none are cast.
     */
    public static int raysPerCell(int cells, int raysPerPoint) {
        int rays = TURNS.length;
        while (rays > 1 && 2 * cells * (rays - 1) > raysPerPoint) {
            rays >>= 1;
        }
        return rays;
    }

    /** Returns the {@code turn} of {@link lightning.render.gather.cell.DirectionTable#write} for a ray of a cell; 0 for ray 0, the point's own. */
    public static int turn(int ray) {
        return TURNS[ray];
    }
}
