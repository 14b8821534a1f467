package lightning.render.measure;

import lightning.base.math.Vec3;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.trace.HitRows;
import lightning.render.trace.SurfacePoint;
import org.jspecify.annotations.Nullable;

/** Ends of paths from a point, with the share of the light that each sends back to it. */
final class GatherPaths {
    final SurfaceColumns ends;
    /** Normals of the surfaces, of length 1; null where a path goes on around that normal. */
    private final Vec3[] geometric;
    /** Share of the light: red, green, blue. */
    final float[][] share;
    int count;

    GatherPaths(int capacity) {
        ends = new SurfaceColumns(capacity);
        geometric = new Vec3[capacity];
        share = new float[3][capacity];
    }

    /**
     * Replaces all paths by the start of them.
     *
     * @param geometric normal of the surface, facing the viewer; null if the point is shaded by it
     */
    void start(SurfacePoint at, @Nullable Vec3 geometric) {
        count = 0;
        add(at.px(), at.py(), at.pz(), at.nx(), at.ny(), at.nz(), geometric, 1, 1, 1);
    }

    /**
     * Adds the end of a path at a row.
     *
     * @param geometric normal of the surface, facing the ray; null if the row is shaded by it
     */
    void add(HitRows rows, int row, @Nullable Vec3 geometric, float red, float green, float blue) {
        add(rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row], rows.nz[row], geometric, red, green, blue);
    }

    private void add(float x, float y, float z, float normalX, float normalY, float normalZ, @Nullable Vec3 normal, float red, float green,
            float blue) {
        ends.set(count, x, y, z, normalX, normalY, normalZ, -1);
        geometric[count] = normal;
        share[0][count] = red;
        share[1][count] = green;
        share[2][count++] = blue;
    }

    /** Mirrors those directions {@code from … to − 1} at the surface that go below it. */
    void reflect(int path, double[] x, double[] y, double[] z, int from, int to) {
        Vec3 normal = geometric[path];
        for (int ray = from; normal != null && ray < to; ray++) {
            Vec3 direction = new Vec3(x[ray], y[ray], z[ray]);
            double depth = -direction.dot(normal);
            if (depth > 0) {
                Vec3 mirrored = direction.plus(normal.times(2 * depth));
                x[ray] = mirrored.x();
                y[ray] = mirrored.y();
                z[ray] = mirrored.z();
            }
        }
    }
}
