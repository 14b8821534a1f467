package lightning.render.shading;

import lightning.render.trace.HitRows;
import lightning.render.trace.RowShadowRays;

/**
 * The terms of the {@link LightingEquation} for one light over all rows of a tile. Whoever computes them gives the equation's
 * bits. Holds scratch columns: one for each thread.
 *
 * <p>First it is aimed at a light; what is asked then is about that light and these rows. Sets of rows are those of
 * {@link RowBits}.
 */
public interface TermKernel {
    /** The rows of a tile at most. */
    int MAX_ROWS = 1024;

    /** As {@link LightingEquation#moveTo}. */
    void aim(HitRows rows, LightSource source);

    /**
     * The same for the sample {@code s} of a light that is larger than a point, for the rows of a set and those that share a word with one; what is asked of
     * others then has no meaning.
     *
     * @param rotations   of each row, see {@link RowShadowRays#rotation}
     * @param cosine gets their {@link LightingEquation#cosine}
     * @param facing gets those of the set with a cosine above 0
     */
    void aim(HitRows rows, LightSource source, int s, double[] rotations, int[] rowSet, float[] cosine, int[] facing);

    /** Leads the ways of the rows of a set, and of those that share a word with one, to sample {@code s} of a light that is larger than a point. */
    void aimShadowRays(HitRows rows, LightSource source, int s, int[] rowSet, RowShadowRays shadowRays);

    /**
     * Of a light that is larger than a point, finds the rows that face any of its samples.
     *
     * @param candidates gets all of these, and maybe others
     */
    void addPossiblyFacing(HitRows rows, LightSource source, int[] candidates);

    /**
     * Likewise those of the rows {@code from … to − 1} that have a {@link LightingEquation#specular} term other than 0 of any of its samples.
     *
     * @param candidates gets all of these, and maybe others, beside what it has
     */
    void addPossibleHighlights(HitRows rows, int from, int to, LightSource source, double shininess, int[] candidates);

    /** Measures the distances to a point light: all that its falloffs need of aiming. */
    void computeDistances(HitRows rows, LightSource source);

    /** Computes the cosines from the axis of the cone of the light that was aimed at. */
    void computeConeCosines(HitRows rows, LightSource source);

    /** Writes {@link LightingEquation#cosine} of all rows. */
    void cosines(HitRows rows, float[] to);

    /** Puts the rows with a cosine above 0 into a set. */
    void selectFacing(float[] cosine, int rows, int[] facing);

    /** Puts those of a set that are in the cone, as {@link LightingEquation#insideCone}, into another; the cone was aimed. */
    void selectInside(int[] candidates, int rows, double cosAngle, int[] inside);

    /** Writes a column: the values of the rows of a set, and 0 for others. */
    void select(float[] values, int[] rowSet, int rows, float[] to);

    /**
     * Writes {@link LightingEquation#specular} of those of the rows {@code from … to − 1} that are in a set.
     *
     * @param column keeps what it holds of other rows
     */
    void speculars(HitRows rows, int from, int to, int[] rowSet, double shininess, float[] column);

    /**
     * Writes {@link LightingEquation#metallicDiffuse} of those of the rows {@code from … to − 1} that are in a set; all of them face the light.
     *
     * @param column keeps what it holds of other rows
     */
    void metallicDiffuses(HitRows rows, int from, int to, int[] rowSet, float[] column);

    /**
     * Writes {@link LightingEquation#metallicSpecular} and {@link LightingEquation#metallicGrazing} of those of the rows {@code from … to − 1} that are in
     * a set; all of them face the light.
     *
     * @param gloss   keeps what it holds of other rows, and {@code grazing} likewise
     */
    void metallicSpeculars(HitRows rows, int from, int to, int[] rowSet, double alpha, float[] gloss, float[] grazing);

    /** Writes {@link LightingEquation#falloff} of all rows: of a point light that was measured, or of a spot light whose cone was aimed. */
    void falloffs(HitRows rows, LightSource source, float[] to);

    /**
     * Adds {@code term · falloff} of the rows of a set to their sums; the product is exact.
     *
     * @param falloff null where it is 1
     */
    void accumulate(float[] term, float[] falloff, int[] rowSet, int rows, double[] sum);

    /** Writes the falloff before it is rounded to float. */
    void unroundedFalloffs(HitRows rows, LightSource source, double[] to);
}
