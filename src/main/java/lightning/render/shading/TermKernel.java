package lightning.render.shading;

import lightning.render.shading.layer.RowBits;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowShadowRays;
import org.jspecify.annotations.Nullable;

/**
 * Kernel that computes the terms of the {@link LightingEquation} for one light over all rows of a tile, with the bits of the
 * equation. Holds scratch columns: use one instance per thread.
 *
 * <p>First call {@code aim}; the other methods then refer to that light and these rows. Sets of rows are {@link RowBits}.
 */
public interface TermKernel {
    /** Maximum number of rows of a tile. */
    int MAX_ROWS = 1024;

    /** Aims at a light from all rows, as {@link LightingEquation#moveTo}. */
    void aim(HitRows rows, LightSource source);

    /**
     * Aims at sample {@code s} of an area light from the rows of a set and the rows that share a word with them. Results for other
     * rows are undefined.
     *
     * @param patterns  sample pattern of each row, see {@link RowShadowRays#pattern}
     * @param cosine    receives their {@link LightingEquation#cosine}
     * @param facing    receives those of the set with a cosine above 0
     */
    void aim(HitRows rows, LightSource source, int s, RowShadowRays patterns, int[] rowSet, float[] cosine, int[] facing);

    /** Sets up shadow rays to sample {@code s} of an area light from the rows of a set and the rows that share a word with them. */
    void aimShadowRays(HitRows rows, LightSource source, int s, int[] rowSet, RowShadowRays shadowRays);

    /**
     * Finds the rows that face any sample of an area light.
     *
     * @param candidates receives all of these and possibly others
     */
    void addPossiblyFacing(HitRows rows, LightSource source, int[] candidates);

    /**
     * Finds those of the rows {@code from … to − 1} with a nonzero {@link LightingEquation#specular} term for any sample of an area
     * light.
     *
     * @param candidates set to which all of these and possibly others are added
     */
    void addPossibleHighlights(HitRows rows, int from, int to, LightSource source, double shininess, int[] candidates);

    /** Computes the distances to a point light, from which its falloffs follow. */
    void computeDistances(HitRows rows, LightSource source);

    /** Computes the cosines from the cone's axis for the light that was aimed at. */
    void computeConeCosines(HitRows rows, LightSource source);

    /** Writes {@link LightingEquation#cosine} of all rows. */
    void cosines(HitRows rows, float[] to);

    /** Adds the rows with a cosine above 0 to a set. */
    void selectFacing(float[] cosine, int rows, int[] facing);

    /** Selects the candidates in the cone, as {@link LightingEquation#insideCone}; expects {@link #computeConeCosines}. */
    void selectInside(int[] candidates, int rows, double cosAngle, int[] inside);

    /** Writes a column: the values of the rows of a set, and 0 for others. */
    void select(float[] values, int[] rowSet, int rows, float[] to);

    /**
     * Writes {@link LightingEquation#specular} of those of the rows {@code from … to − 1} that are in a set.
     *
     * @param column keeps its values of other rows
     */
    void speculars(HitRows rows, int from, int to, int[] rowSet, double shininess, float[] column);

    /**
     * Writes {@link LightingEquation#metallicDiffuse} of those of the rows {@code from … to − 1} that are in a set; all of them
     * face the light.
     *
     * @param column keeps its values of other rows
     */
    void metallicDiffuses(HitRows rows, int from, int to, int[] rowSet, float[] column);

    /**
     * Writes {@link LightingEquation#metallicSpecular} and {@link LightingEquation#metallicGrazing} of those of the rows {@code
     * from … to − 1} that are in a set. All of them face the light.
     *
     * @param gloss keeps its values of other rows, as {@code grazing} does
     */
    void metallicSpeculars(HitRows rows, int from, int to, int[] rowSet, double alpha, float[] gloss, float[] grazing);

    /**
     * Writes the same terms of rows of different roughness.
     *
     * @param alpha width of the highlights of each row, {@code double[MAX_ROWS]}; unread for rows that are not in the set
     */
    void metallicSpeculars(HitRows rows, int from, int to, int[] rowSet, double[] alpha, float[] gloss, float[] grazing);

    /**
     * Writes the same terms of {@link LightingEquation#anisotropicFacets}, of rows with tangents.
     *
     * @param alpha width α of the roughness of each row
     */
    void anisotropicSpeculars(HitRows rows, int from, int to, int[] rowSet, AnisotropicHighlight highlight, double[] alpha, float[] gloss,
            float[] grazing);

    /**
     * Writes {@link LightingEquation#sheen} of those of the rows {@code from … to − 1} that are in a set. All of them face the light.
     *
     * @param roughness of the sheen of each row, {@code double[MAX_ROWS]}; unread for rows that are not in the set
     * @param column keeps its values of other rows
     */
    void sheens(HitRows rows, int from, int to, int[] rowSet, double[] roughness, float[] column);

    /**
     * Writes {@link LightingEquation#falloff} of all rows; expects {@link #computeDistances} for a point light, {@link
     * #computeConeCosines} for a spot light.
     */
    void falloffs(HitRows rows, LightSource source, float[] to);

    /**
     * Adds {@code term · falloff} of the rows of a set to their sums; the product is exact.
     *
     * @param falloff null if it is 1
     */
    void accumulate(float[] term, float @Nullable [] falloff, int[] rowSet, int rows, double[] sum);

    /** Writes the falloff before it is rounded to float. */
    void unroundedFalloffs(HitRows rows, LightSource source, double[] to);
}
