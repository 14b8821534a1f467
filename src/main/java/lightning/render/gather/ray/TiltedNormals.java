package lightning.render.gather.ray;

import java.io.IOException;
import java.util.Arrays;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;

/**
 * Unit normals of the surfaces at those points that are shaded by another normal. Immutable.
 *
 * @param point these points, ascending
 * @param x     components of their normals, with {@code y} and {@code z}
 */
public record TiltedNormals(int[] point, float[] x, float[] y, float[] z) {
    // Arrays in a record: written once by their creator, never after.

    /** @param x components of the normals of all points, with {@code y} and {@code z}; NaN where a point is shaded by this normal */
    static TiltedNormals of(float[] x, float[] y, float[] z) {
        int count = 0;
        for (float component : x) {
            count += component == component ? 1 : 0;
        }
        var normals = new TiltedNormals(new int[count], new float[count], new float[count], new float[count]);
        int at = 0;
        for (int p = 0; p < x.length; p++) {
            if (x[p] == x[p]) {
                normals.point[at] = p;
                normals.x[at] = x[p];
                normals.y[at] = y[p];
                normals.z[at++] = z[p];
            }
        }
        return normals;
    }

    /** Returns the index of a point's normal; negative for none. */
    int index(int p) {
        return point.length == 0 ? -1 : Arrays.binarySearch(point, p);
    }

    public void writeTo(ColumnWriter out) throws IOException {
        out.writeArray(point);
        out.writeFloatArrays(new float[][] {x, y, z});
    }

    public static TiltedNormals readFrom(ColumnReader in) throws IOException {
        int[] point = in.readInts();
        float[][] normals = in.readFloatArrays();
        return new TiltedNormals(point, normals[0], normals[1], normals[2]);
    }

    public long bytes() {
        return 16L * point.length;
    }
}
