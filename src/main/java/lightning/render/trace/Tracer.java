package lightning.render.trace;

import lightning.render.trace.primitive.ShadowRayHits;
import lightning.render.trace.primitive.SurfaceHit;
import lightning.render.trace.tree.CandidateList;
import lightning.render.trace.tree.PointBox;

/**
 * Finds what the rays of a tile meet, all of them in one call. Whoever does it gives the same bits as the scalar functions of
 * {@link Geometry} and {@link SurfaceHit}. Holds scratch memory: one for each thread.
 *
 * <p>Sets of rows are bits of {@code int}s, {@link #ROWS_PER_WORD} in each, the lowest for the first row.
 */
public interface Tracer {
    /** Rows in an {@code int} of a set. */
    int ROWS_PER_WORD = 16;

    /** Directs rays of the eye through the centers of a rectangle of pixels, line by line. */
    void directEyeRays(CameraRays camera, int column, int row, int columns, int lines, RayColumns rays);

    /** Directs rays of the eye through finer samples, at most 1024. */
    void directSampleRays(CameraRays camera, SamplePositions positions, RayColumns rays);

    /**
     * Writes {@code t} and {@code primitive} of all rays.
     *
     * @param candidates of a beam that all rays are in
     */
    void findNearest(RayColumns rays, CandidateList candidates);

    /** Writes {@code t} of all rays, whose {@code primitive} is known without a search. */
    void writeDistances(RayColumns rays);

    /** Writes points and normals of all hits, in their order, to rows, and {@link RayColumns#localX} and its like if {@code withLocalPoints}. */
    void writeSurfaces(RayColumns rays, HitRows rows, boolean withLocalPoints);

    /** Writes {@link RayColumns#localX} and its like of all hits alone. */
    void writeLocalPoints(RayColumns rays);

    /**
     * Finds out from which rows a light is not seen.
     *
     * @param selected     the rows to ask
     * @param shadowRays       where the ways from the rows lead
     * @param candidates of a beam that all ways are in
     * @param blocked    gets those rows among the chosen
     */
    void findBlocked(HitRows rows, int[] selected, ShadowRays shadowRays, CandidateList candidates, int[] blocked);

    /** The same where each row's way leads elsewhere. */
    void findBlocked(HitRows rows, int[] selected, RowShadowRays shadowRays, CandidateList candidates, int[] blocked);

    /**
     * Finds all places where ways from rows meet some shapes.
     *
     * @param selected     the rows to ask
     * @param candidates of a beam that all ways are in, not too many
     * @param hits         gets the places, of ways with the numbers of the rows
     */
    void findHits(HitRows rows, int[] selected, RowShadowRays shadowRays, CandidateList candidates, ShadowRayHits hits);

    /** One that does it the same way among other shapes. */
    Tracer withGeometry(Geometry geometry);

    /** The box of points {@code from … to − 1}, at least one. */
    PointBox bounds(float[] x, float[] y, float[] z, int from, int to);

    /** Writes the least and the greatest of the values {@code 0 … count − 1}, at least one, to {@code range[0]} and {@code range[1]}. */
    void range(double[] values, int count, double[] range);
}
