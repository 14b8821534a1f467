package lightning.render.gather.ray;

import java.io.IOException;
import java.util.Arrays;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;

/**
 * Surfaces under those points that are shaded by another normal than that of their surface. Immutable.
 *
 * @param point these points, ascending
 * @param normal x, y and z of the surfaces' unit normals
 * @param start  x, y and z of the places at which rays of the points start, render space
 */
public record TiltedFacets(int[] point, float[][] normal, float[][] start) {
    // Arrays in a record: written once by their creator, never after.

    /**
     * @param normals of all points; NaN where a point is shaded by this normal
     * @param starts  of all points
     */
    static TiltedFacets of(float[][] normals, float[][] starts) {
        int count = 0;
        for (float component : normals[0]) {
            count += component == component ? 1 : 0;
        }
        var facets = new TiltedFacets(new int[count], new float[3][count], new float[3][count]);
        int at = 0;
        for (int p = 0; p < normals[0].length; p++) {
            if (normals[0][p] == normals[0][p]) {
                facets.point[at] = p;
                for (int axis = 0; axis < 3; axis++) {
                    facets.normal[axis][at] = normals[axis][p];
                    facets.start[axis][at] = starts[axis][p];
                }
                at++;
            }
        }
        return facets;
    }

    /** Returns the index of a point's facet; negative for none. */
    int index(int p) {
        return point.length == 0 ? -1 : Arrays.binarySearch(point, p);
    }

    public void writeTo(ColumnWriter out) throws IOException {
        out.writeArray(point);
        out.writeFloatArrays(normal);
        out.writeFloatArrays(start);
    }

    public static TiltedFacets readFrom(ColumnReader in) throws IOException {
        return new TiltedFacets(in.readInts(), in.readFloatArrays(), in.readFloatArrays());
    }

    public long bytes() {
        return 28L * point.length;
    }
}
