package lightning.render.gather.cell;

import java.io.IOException;
import java.util.Arrays;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;

/** Points on surfaces with their normals, as columns that share one index. Render space. */
public final class SurfaceColumns {
    public int count;
    public float[] px;
    public float[] py;
    public float[] pz;
    /** Unit normals, facing the ray that hit the point. */
    public float[] nx;
    public float[] ny;
    public float[] nz;
    public int[] primitive;

    public SurfaceColumns() {
        this(1024);
    }

    /** @param capacity points for which there is room */
    public SurfaceColumns(int capacity) {
        px = new float[capacity];
        py = new float[capacity];
        pz = new float[capacity];
        nx = new float[capacity];
        ny = new float[capacity];
        nz = new float[capacity];
        primitive = new int[capacity];
    }

    /** Keeps the first points only, and no room for others. */
    public void trim(int points) {
        count = points;
        resize(points);
    }

    private void resize(int length) {
        px = Arrays.copyOf(px, length);
        py = Arrays.copyOf(py, length);
        pz = Arrays.copyOf(pz, length);
        nx = Arrays.copyOf(nx, length);
        ny = Arrays.copyOf(ny, length);
        nz = Arrays.copyOf(nz, length);
        primitive = Arrays.copyOf(primitive, length);
    }

    public void writeTo(ColumnWriter out) throws IOException {
        out.writeInt(count);
        for (float[] column : new float[][] {px, py, pz, nx, ny, nz}) {
            out.writeArray(Arrays.copyOf(column, count));
        }
        out.writeArray(Arrays.copyOf(primitive, count));
    }

    public static SurfaceColumns readFrom(ColumnReader in) throws IOException {
        var columns = new SurfaceColumns(0);
        columns.count = in.readInt();
        columns.px = in.readFloats();
        columns.py = in.readFloats();
        columns.pz = in.readFloats();
        columns.nx = in.readFloats();
        columns.ny = in.readFloats();
        columns.nz = in.readFloats();
        columns.primitive = in.readInts();
        return columns;
    }

    /** Returns the number of points. */
    public int count() {
        return count;
    }

    /** Makes room for {@code total} points. */
    public void reserve(int total) {
        if (total > px.length) {
            resize(Math.max(total, px.length + px.length / 2));
        }
    }

    /** Writes a point at an index for which there is room. */
    public void set(int i, float x, float y, float z, float ax, float ay, float az, int hit) {
        px[i] = x;
        py[i] = y;
        pz[i] = z;
        nx[i] = ax;
        ny[i] = ay;
        nz[i] = az;
        primitive[i] = hit;
    }

    /**
     * Appends a point.
     *
     * @param ax unit normal, with {@code ay} and {@code az}
     */
    public void add(float x, float y, float z, float ax, float ay, float az, int hit) {
        reserve(count + 1);
        set(count++, x, y, z, ax, ay, az, hit);
    }

    /** Appends a point of other columns. */
    public void add(SurfaceColumns from, int i) {
        reserve(count + 1);
        set(count++, from, i);
    }

    /** Writes a point of other columns at an index for which there is room. */
    public void set(int to, SurfaceColumns from, int i) {
        set(to, from.px[i], from.py[i], from.pz[i], from.nx[i], from.ny[i], from.nz[i], from.primitive[i]);
    }
}
