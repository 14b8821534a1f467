package lightning.render.gather.point;

import java.io.IOException;
import java.util.Arrays;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.gather.cell.DirectionTable;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.ray.RayLinks;
import lightning.render.gather.ray.RaySources;
import lightning.render.trace.Geometry;

/**
 * Barriers of gather points: planes that separate a point from the places behind them ({@link BarrierFinder}), so that light does not pass a
 * thin wall. Immutable.
 *
 * @param first  first barrier of each point; after the last point their number
 * @param values {@link BarrierFinder#VALUES} of each barrier
 */
public record Barriers(int[] first, float[] values) {
    // Arrays in a record: written once by their creator, never after.

    /** No barriers at any point. */
    public static final Barriers NONE = new Barriers(new int[0], new float[0]);
    /** Points in a job. */
    private static final int BATCH = 1024;

    /** Returns the barriers of all points. */
    public static Barriers of(RaySources points, float[] radius, RayLinks links, SurfaceColumns surfels, Geometry geometry,
            DirectionTable directions, WorkerPool workers, Progress progress) {
        int count = points.surface.count;
        int[] counts = new int[count + 1];
        float[][] parts = new float[Math.ceilDiv(count, BATCH)][];
        BarrierFinder[] finders = new BarrierFinder[workers.count()];
        workers.run(parts.length, (worker, job) -> {
            finders[worker] = finders[worker] == null ? new BarrierFinder(directions.rays()) : finders[worker];
            parts[job] = find(finders[worker], points, radius, links, surfels, geometry, directions, job * BATCH,
                    Math.min(count, job * BATCH + BATCH), counts);
        }, progress.cancellationOnly());
        int[] first = new int[count + 1];
        for (int p = 0; p < count; p++) {
            first[p + 1] = first[p] + counts[p];
        }
        float[] values = new float[first[count] * BarrierFinder.VALUES];
        int at = 0;
        for (float[] part : parts) {
            System.arraycopy(part, 0, values, at, part.length);
            at += part.length;
        }
        return new Barriers(first, values);
    }

    private static float[] find(BarrierFinder finder, RaySources points, float[] radius, RayLinks links, SurfaceColumns surfels,
            Geometry geometry, DirectionTable directions, int from, int to, int[] counts) {
        SurfaceColumns at = points.surface;
        float[] values = new float[(to - from) * BarrierFinder.MAX * BarrierFinder.VALUES];
        int length = 0;
        for (int p = from; p < to; p++) {
            boolean any = false;
            for (int k = 0; k < directions.rays(); k++) {
                int s = links.surfel(p * directions.rays() + k);
                if (s == RayLinks.MISS || geometry.hasBentNormals(surfels.primitive[s])) {
                    finder.setMiss(k);
                } else {
                    finder.setHit(k, surfels.px[s], surfels.py[s], surfels.pz[s], surfels.nx[s], surfels.ny[s], surfels.nz[s]);
                    any = true;
                }
            }
            if (any) {
                points.writeDirections(p, directions, finder.dx, finder.dy, finder.dz, 0);
                counts[p] = finder.find(at.px[p], at.py[p], at.pz[p], at.nx[p], at.ny[p], at.nz[p], radius[p]);
                System.arraycopy(finder.found, 0, values, length, counts[p] * BarrierFinder.VALUES);
                length += counts[p] * BarrierFinder.VALUES;
            }
        }
        return Arrays.copyOf(values, length);
    }

    /**
     * Returns the barriers of one point, whose rays a finder has.
     *
     * @param p      point among some points
     * @param radius of the point, scene units
     */
    public static Barriers ofPoint(BarrierFinder finder, SurfaceColumns points, int p, float radius) {
        int count = finder.find(points.px[p], points.py[p], points.pz[p], points.nx[p], points.ny[p], points.nz[p], radius);
        int[] first = new int[points.count + 1];
        Arrays.fill(first, p + 1, first.length, count);
        return new Barriers(first, Arrays.copyOf(finder.found, count * BarrierFinder.VALUES));
    }

    /** Returns whether a barrier of a point separates it from a place, in render space. */
    public boolean separate(SurfaceColumns points, int p, float x, float y, float z) {
        for (int b = values.length == 0 ? 0 : first[p], end = values.length == 0 ? 0 : first[p + 1]; b < end; b++) {
            if (separates(BarrierFinder.VALUES * b, points, p, x, y, z)) {
                return true;
            }
        }
        return false;
    }

    private boolean separates(int at, SurfaceColumns points, int p, float x, float y, float z) {
        float bx = values[at];
        float by = values[at + 1];
        float bz = values[at + 2];
        double toX = (double) x - points.px[p];
        double toY = (double) y - points.py[p];
        double toZ = (double) z - points.pz[p];
        double before = values[at + 3];
        double behind = -(before + bx * toX + by * toY + bz * toZ);
        if (!(behind > 0)) {
            return false;
        }
        double along = toX * BarrierFinder.alongX(by, bz, points.ny[p], points.nz[p])
                + toY * BarrierFinder.alongX(bz, bx, points.nz[p], points.nx[p])
                + toZ * BarrierFinder.alongX(bx, by, points.nx[p], points.ny[p]);
        double crossing = along * (before / (before + behind));
        return crossing > values[at + 4] && crossing < values[at + 5];
    }

    /** Returns whether a point has the same barriers as one of others. */
    public boolean areSame(int p, Barriers others, int q) {
        return Arrays.equals(values, BarrierFinder.VALUES * first[p], BarrierFinder.VALUES * first[p + 1], others.values,
                BarrierFinder.VALUES * others.first[q], BarrierFinder.VALUES * others.first[q + 1]);
    }

    void writeTo(ColumnWriter out) throws IOException {
        out.writeArray(first);
        out.writeArray(values);
    }

    static Barriers readFrom(ColumnReader in) throws IOException {
        return new Barriers(in.readInts(), in.readFloats());
    }

    public long bytes() {
        return 4L * (first.length + values.length);
    }
}
