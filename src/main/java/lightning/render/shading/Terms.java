package lightning.render.shading;

import lightning.render.trace.HitRows;
import lightning.render.trace.RowWays;

/**
 * The terms of the {@link LightingEquation} for one light over all rows of a tile. Whoever computes them gives the equation's
 * bits. Holds scratch columns: one for each thread.
 *
 * <p>First it is aimed at a light; what is asked then is about that light and these rows. Sets of rows are those of
 * {@link RowBits}.
 */
public interface Terms {
    /** The rows of a tile at most. */
    int ROWS = 1024;

    /** As {@link LightingEquation#at}. */
    void aim(HitRows rows, Lamp lamp);

    /**
     * The same for the sample {@code s} of a light that is larger than a point, for the rows of a set and those that share a word with one; what is asked of
     * others then has no meaning.
     *
     * @param turn   of each row, see {@link RowWays#turn}
     * @param cosine gets their {@link LightingEquation#cosine}
     * @param facing gets those of the set with a cosine above 0
     */
    void aim(HitRows rows, Lamp lamp, int s, double[] turn, int[] which, float[] cosine, int[] facing);

    /** Leads the ways of the rows of a set, and of those that share a word with one, to sample {@code s} of a light that is larger than a point. */
    void lead(HitRows rows, Lamp lamp, int s, int[] which, RowWays ways);

    /**
     * Of a light that is larger than a point, finds the rows that face any of its samples.
     *
     * @param may gets all of these, and maybe others
     */
    void mayFace(HitRows rows, Lamp lamp, int[] may);

    /**
     * Likewise those of the rows {@code from … to − 1} that have a {@link LightingEquation#specular} term other than 0 of any of its samples.
     *
     * @param may gets all of these, and maybe others, beside what it has
     */
    void mayShine(HitRows rows, int from, int to, Lamp lamp, double shininess, int[] may);

    /** Measures the distances to a point light: all that its falloffs need of aiming. */
    void measure(HitRows rows, Lamp lamp);

    /** Computes the cosines from the axis of the cone of the light that was aimed at. */
    void aimCone(HitRows rows, Lamp lamp);

    /** Writes {@link LightingEquation#cosine} of all rows. */
    void cosines(HitRows rows, float[] to);

    /** Puts the rows with a cosine above 0 into a set. */
    void facing(float[] cosine, int rows, int[] facing);

    /** Puts those of a set that are in the cone, as {@link LightingEquation#insideCone}, into another; the cone was aimed. */
    void inside(int[] among, int rows, double cosAngle, int[] inside);

    /** Writes a column: the values of the rows of a set, and 0 for others. */
    void select(float[] values, int[] which, int rows, float[] to);

    /**
     * Writes {@link LightingEquation#specular} of those of the rows {@code from … to − 1} that are in a set.
     *
     * @param column keeps what it holds of other rows
     */
    void speculars(HitRows rows, int from, int to, int[] which, double shininess, float[] column);

    /**
     * Writes {@link LightingEquation#matte} of those of the rows {@code from … to − 1} that are in a set; all of them face the light.
     *
     * @param column keeps what it holds of other rows
     */
    void mattes(HitRows rows, int from, int to, int[] which, float[] column);

    /**
     * Writes {@link LightingEquation#gloss} and {@link LightingEquation#grazing} of those of the rows {@code from … to − 1} that are in
     * a set; all of them face the light.
     *
     * @param gloss   keeps what it holds of other rows, and {@code grazing} likewise
     */
    void glosses(HitRows rows, int from, int to, int[] which, double alpha, float[] gloss, float[] grazing);

    /** Writes {@link LightingEquation#falloff} of all rows: of a point light that was measured, or of a spot light whose cone was aimed. */
    void falloffs(HitRows rows, Lamp lamp, float[] to);

    /**
     * Adds {@code term · falloff} of the rows of a set to their sums; the product is exact.
     *
     * @param falloff null where it is 1
     */
    void add(float[] term, float[] falloff, int[] which, int rows, double[] sum);

    /** Writes the falloff before it is rounded to float. */
    void factors(HitRows rows, Lamp lamp, double[] to);
}
