package lightning.render.trace;

import java.util.Arrays;

/**
 * Order of rays by their directions, so that packets of neighbors are coherent. Directions are divided into the cells of a grid on each
 * face of a cube, along a Z-shaped curve. Holds scratch memory: use one per thread.
 */
final class DirectionOrder {
    private static final int FACES = 6;
    /** Cells along the side of a face; a power of 2. */
    private static final int SIDE = 8;
    private static final int CELLS = FACES * SIDE * SIDE;
    /** Position on the curve of each cell of a face. */
    private static final int[] CURVE = new int[SIDE * SIDE];

    static {
        for (int cell = 0; cell < CURVE.length; cell++) {
            for (int bit = 1; bit < SIDE; bit *= 2) {
                CURVE[cell] |= (cell % SIDE & bit) * bit | (cell / SIDE & bit) * bit * 2;
            }
        }
    }

    private final short[] cells;
    private final int[] starts = new int[CELLS + 1];

    DirectionOrder(int maxRays) {
        cells = new short[maxRays];
    }

    /** Writes the first {@code count} of some rays in the order of their directions; rays of one cell keep their order. */
    void sort(short[] selected, int count, RayColumns rays, short[] to) {
        Arrays.fill(starts, 0);
        for (int i = 0; i < count; i++) {
            int ray = selected[i];
            cells[i] = (short) cell(rays.dx[ray], rays.dy[ray], rays.dz[ray]);
            starts[cells[i] + 1]++;
        }
        for (int cell = 0; cell < CELLS; cell++) {
            starts[cell + 1] += starts[cell];
        }
        for (int i = 0; i < count; i++) {
            to[starts[cells[i]]++] = selected[i];
        }
    }

    private static int cell(double x, double y, double z) {
        double ax = Math.abs(x);
        double ay = Math.abs(y);
        double az = Math.abs(z);
        return ax >= ay && ax >= az ? cell(x > 0 ? 0 : 1, y / ax, z / ax)
                : ay >= az ? cell(y > 0 ? 2 : 3, x / ay, z / ay) : cell(z > 0 ? 4 : 5, x / az, y / az);
    }

    /** @param u coordinate on the face, −1…1, with {@code v} */
    private static int cell(int face, double u, double v) {
        return face * SIDE * SIDE + CURVE[along(v) * SIDE + along(u)];
    }

    private static int along(double u) {
        return Math.clamp((long) ((u + 1) * (SIDE / 2.0)), 0, SIDE - 1);
    }
}
