package lightning.render.gather;

import java.util.Arrays;

/** Points on surfaces with their normals, as columns that share one index. Render space. */
final class SurfaceColumns {
    int count;
    float[] px = new float[1024];
    float[] py = new float[1024];
    float[] pz = new float[1024];
    /** Unit normals, facing the ray that hit the point. */
    float[] nx = new float[1024];
    float[] ny = new float[1024];
    float[] nz = new float[1024];
    int[] primitive = new int[1024];

    /** Makes room for {@code total} points. */
    void reserve(int total) {
        if (total > px.length) {
            int length = Math.max(total, px.length + px.length / 2);
            px = Arrays.copyOf(px, length);
            py = Arrays.copyOf(py, length);
            pz = Arrays.copyOf(pz, length);
            nx = Arrays.copyOf(nx, length);
            ny = Arrays.copyOf(ny, length);
            nz = Arrays.copyOf(nz, length);
            primitive = Arrays.copyOf(primitive, length);
        }
    }

    /** Writes a point at an index for which there is room. */
    void set(int i, float x, float y, float z, float ax, float ay, float az, int hit) {
        px[i] = x;
        py[i] = y;
        pz[i] = z;
        nx[i] = ax;
        ny[i] = ay;
        nz[i] = az;
        primitive[i] = hit;
    }

    /** Appends a point of other columns. */
    void add(SurfaceColumns from, int i) {
        reserve(count + 1);
        set(count++, from.px[i], from.py[i], from.pz[i], from.nx[i], from.ny[i], from.nz[i], from.primitive[i]);
    }
}
