package lightning.render.trace;

import lightning.base.math.PowerFunction;
import lightning.render.trace.primitive.ShadowRayHits;
import lightning.render.trace.primitive.SurfaceHit;
import lightning.render.trace.tree.CandidateList;
import lightning.render.trace.tree.PointBox;

/**
 * Traces all rays of a tile in one call. Every implementation returns the same bits as the scalar functions of {@link Geometry}
 * and {@link SurfaceHit}. Implementations hold scratch memory: use one per thread.
 *
 * <p>Sets of rows are bits of {@code int}s, {@link #ROWS_PER_WORD} in each, the lowest bit for the first row.
 */
public interface Tracer {
    /** Rows per {@code int} of a set. */
    int ROWS_PER_WORD = 16;
    /** Lanes may overrun the end of an array by less than this. */
    int EXPONENTIALS_OVERRUN = 32;

    /** Sets camera rays through the centers of a rectangle of pixels, line by line. */
    void directEyeRays(CameraRays camera, int column, int row, int columns, int lines, RayColumns rays);

    /** Sets camera rays through finer samples, at most 1024. */
    void directSampleRays(CameraRays camera, SamplePositions positions, RayColumns rays);

    /**
     * Writes {@code t} and {@code primitive} of all rays.
     *
     * @param candidates candidates of a beam that contains all rays
     */
    void findNearest(RayColumns rays, CandidateList candidates);

    /** Writes {@code t} of all rays, whose {@code primitive} is already known. */
    void writeDistances(RayColumns rays);

    /**
     * Writes points and normals of all hits, in order, to rows; with {@code withLocalPoints} also {@link RayColumns#localX} to
     * {@code localZ}.
     */
    void writeSurfaces(RayColumns rays, HitRows rows, boolean withLocalPoints);

    /** Writes only {@link RayColumns#localX} to {@code localZ} of all hits. */
    void writeLocalPoints(RayColumns rays);

    /**
     * Finds the rows from which a light is blocked.
     *
     * @param selected rows to test
     * @param shadowRays shadow rays from the rows
     * @param candidates candidates of a beam that contains all shadow rays
     * @param blocked receives the blocked rows among the selected
     */
    void findBlocked(HitRows rows, int[] selected, ShadowRays shadowRays, CandidateList candidates, int[] blocked);

    /** Finds the rows from which a light is blocked; each row has a shadow ray of its own. */
    void findBlocked(HitRows rows, int[] selected, RowShadowRays shadowRays, CandidateList candidates, int[] blocked);

    /**
     * Finds all hits of shadow rays on some shapes.
     *
     * @param candidates candidates of a beam that contains all shadow rays; their number is limited
     * @param hits receives the hits
     */
    void findHits(ShadowRayBatch rays, CandidateList candidates, ShadowRayHits hits);

    /** Writes {@link ShadowRayHits#reflectance} and {@link ShadowRayHits#inside} of all hits, which are on clear shapes. */
    void writeHitSurfaces(ShadowRayBatch rays, ShadowRayHits hits);

    /**
     * Replaces values by their {@link PowerFunction#exponential}, values of −∞ by 0.
     *
     * @param values longer than {@code count} by {@link #EXPONENTIALS_OVERRUN}
     */
    void exponentials(double[] values, int count);

    /** Returns a tracer of the same kind for another geometry. */
    Tracer withGeometry(Geometry geometry);

    /** Returns the bounds of points {@code from … to − 1}, at least one. */
    default PointBox bounds(float[] x, float[] y, float[] z, int from, int to) {
        PointBox box = new PointBox();
        setRange(x, from, to, box, 0);
        setRange(y, from, to, box, 1);
        setRange(z, from, to, box, 2);
        return box;
    }

    /** Sets the bounds on one axis to those of the values {@code from … to − 1}, at least one. */
    void setRange(float[] values, int from, int to, PointBox box, int axis);

    /**
     * Writes the minimum and the maximum of the values {@code 0 … count − 1}, at least one, to {@code range[0]} and
     * {@code range[1]}.
     */
    void range(double[] values, int count, double[] range);
}
