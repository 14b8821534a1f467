package lightning.bench.accuracy;

import lightning.render.trace.HitRows;

/** Ends of paths from a point, with the share of the light that each sends back to it. */
final class GatherPaths {
    final float[] px;
    final float[] py;
    final float[] pz;
    final float[] nx;
    final float[] ny;
    final float[] nz;
    /** Share of the light: red, green, blue. */
    final float[][] share;
    int count;

    GatherPaths(int capacity) {
        px = new float[capacity];
        py = new float[capacity];
        pz = new float[capacity];
        nx = new float[capacity];
        ny = new float[capacity];
        nz = new float[capacity];
        share = new float[3][capacity];
    }

    /** Replaces all paths by the start of them. */
    void start(float x, float y, float z, float normalX, float normalY, float normalZ) {
        count = 0;
        add(x, y, z, normalX, normalY, normalZ, 1, 1, 1);
    }

    /** Adds the end of a path at a row. */
    void add(HitRows rows, int row, float red, float green, float blue) {
        add(rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row], rows.nz[row], red, green, blue);
    }

    private void add(float x, float y, float z, float normalX, float normalY, float normalZ, float red, float green, float blue) {
        px[count] = x;
        py[count] = y;
        pz[count] = z;
        nx[count] = normalX;
        ny[count] = normalY;
        nz[count] = normalZ;
        share[0][count] = red;
        share[1][count] = green;
        share[2][count++] = blue;
    }
}
