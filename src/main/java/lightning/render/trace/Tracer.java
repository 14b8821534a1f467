package lightning.render.trace;

import lightning.render.trace.primitive.Crossings;
import lightning.render.trace.primitive.Surface;
import lightning.render.trace.tree.Candidates;
import lightning.render.trace.tree.PointBox;

/**
 * Finds what the rays of a tile meet, all of them in one call. Whoever does it gives the same bits as the scalar functions of
 * {@link Geometry} and {@link Surface}. Holds scratch memory: one for each thread.
 *
 * <p>Sets of rows are bits of {@code int}s, {@link #WORD} in each, the lowest for the first row.
 */
public interface Tracer {
    /** Rows in an {@code int} of a set. */
    int WORD = 16;

    /** Directs rays of the eye through the centres of a rectangle of pixels, line by line. */
    void eye(CameraRays camera, int column, int row, int columns, int lines, RayColumns rays);

    /** Directs rays of the eye through finer samples, at most 1024. */
    void samples(CameraRays camera, SamplePlaces places, RayColumns rays);

    /**
     * Writes {@code t} and {@code primitive} of all rays.
     *
     * @param candidates of a beam that all rays are in
     */
    void nearest(RayColumns rays, Candidates candidates);

    /** Writes {@code t} of all rays, whose {@code primitive} is known without a search. */
    void distances(RayColumns rays);

    /** Writes points and normals of all hits, in their order, to rows, and {@link RayColumns#ownX} and its like if {@code own}. */
    void surfaces(RayColumns rays, HitRows rows, boolean own);

    /** Writes {@link RayColumns#ownX} and its like of all hits alone. */
    void ownPoints(RayColumns rays);

    /**
     * Finds out from which rows a light is not seen.
     *
     * @param chosen     the rows to ask
     * @param ways       where the ways from the rows lead
     * @param candidates of a beam that all ways are in
     * @param blocked    gets those rows among the chosen
     */
    void blocked(HitRows rows, int[] chosen, Ways ways, Candidates candidates, int[] blocked);

    /** The same where each row's way leads elsewhere. */
    void blocked(HitRows rows, int[] chosen, RowWays ways, Candidates candidates, int[] blocked);

    /**
     * Finds all places where ways from rows meet some shapes.
     *
     * @param chosen     the rows to ask
     * @param candidates of a beam that all ways are in, not too many
     * @param to         gets the places, of ways with the numbers of the rows
     */
    void cross(HitRows rows, int[] chosen, RowWays ways, Candidates candidates, Crossings to);

    /** One that does it the same way among other shapes. */
    Tracer among(Geometry others);

    /** The box of points {@code from … to − 1}, at least one. */
    PointBox box(float[] x, float[] y, float[] z, int from, int to);

    /** Writes the least and the greatest of the values {@code 0 … count − 1}, at least one, to {@code range[0]} and {@code range[1]}. */
    void range(double[] values, int count, double[] range);
}
