package lightning.render.gather.cell;

import java.io.IOException;
import java.util.Arrays;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;

/** Unit tangents of points with anisotropic materials, 0 for others. Columns without any tangent have no length. */
public final class TangentColumns {
    private float[] x = {};
    private float[] y = {};
    private float[] z = {};

    public void writeTo(ColumnWriter out) throws IOException {
        out.writeArray(x);
        out.writeArray(y);
        out.writeArray(z);
    }

    public static TangentColumns readFrom(ColumnReader in) throws IOException {
        var columns = new TangentColumns();
        columns.x = in.readFloats();
        columns.y = in.readFloats();
        columns.z = in.readFloats();
        return columns;
    }

    /** Sets the tangent of point {@code i}, which has none. */
    public void set(int i, float tx, float ty, float tz) {
        if (tx == 0 && ty == 0 && tz == 0) {
            return;
        }
        if (i >= x.length) {
            int length = Math.max(i + 1, 2 * x.length);
            x = Arrays.copyOf(x, length);
            y = Arrays.copyOf(y, length);
            z = Arrays.copyOf(z, length);
        }
        x[i] = tx;
        y[i] = ty;
        z[i] = tz;
    }

    /** Sets the tangent of a point to that of point {@code i} of others. */
    public void set(int to, TangentColumns from, int i) {
        if (i < from.x.length) {
            set(to, from.x[i], from.y[i], from.z[i]);
        }
    }

    /** Keeps the first tangents only. */
    public void trim(int count) {
        if (x.length > count) {
            x = Arrays.copyOf(x, count);
            y = Arrays.copyOf(y, count);
            z = Arrays.copyOf(z, count);
        }
    }

    public float x(int i) {
        return i < x.length ? x[i] : 0;
    }

    public float y(int i) {
        return i < y.length ? y[i] : 0;
    }

    public float z(int i) {
        return i < z.length ? z[i] : 0;
    }

    public long bytes() {
        return 12L * x.length;
    }
}
