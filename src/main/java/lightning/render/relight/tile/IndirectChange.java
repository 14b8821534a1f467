package lightning.render.relight.tile;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.render.gather.RowWeights;
import lightning.render.shading.IndirectLight;
import org.jspecify.annotations.Nullable;

/**
 * Gather points whose light an update changes. Rows far from these keep their colors.
 *
 * @param colors true for each gather point, then each reflection point, with other light; null if no point has
 * @param edges true for each point with other light as edge detection sees it; null if no point has
 */
record IndirectChange(boolean @Nullable [] colors, boolean @Nullable [] edges, boolean isAll) {
    static final IndirectChange NONE = new IndirectChange(null, null, false);
    private static final IndirectChange ALL = new IndirectChange(null, null, true);

    /** Compares the indirect light of two pictures, each null if there is none. */
    static IndirectChange between(@Nullable IndirectLight before, @Nullable IndirectLight after) {
        if (before == after) {
            return NONE;
        }
        if (before == null || after == null || before.structure() != after.structure()) {
            return ALL;
        }
        // Colors by which edges are detected are new if there were none before.
        return new IndirectChange(changedPoints(before.light(), after.light()), before.edgeLight() == null || after.edgeLight() == null
                ? null : changedPoints(before.edgeLight(), after.edgeLight()), false);
    }

    private static boolean @Nullable [] changedPoints(float[][] before, float[][] after) {
        boolean[] changed = null;
        int gathering = after[0].length;
        int reflecting = after.length > 3 ? after[3].length : 0;
        for (int c = 0; c < after.length; c++) {
            if (before[c] != after[c] && !Arrays.equals(before[c], after[c])) {
                changed = changed == null ? new boolean[gathering + reflecting] : changed;
                int first = c < 3 ? 0 : gathering;
                for (int p = 0; p < after[c].length; p++) {
                    changed[first + p] |= Float.floatToRawIntBits(before[c][p]) != Float.floatToRawIntBits(after[c][p]);
                }
            }
        }
        return changed;
    }

    /**
     * Returns whether the indirect light of any row of a level changes.
     *
     * @param weights weights of the level after the update; null if there is no indirect light
     */
    boolean changesColors(@Nullable RowWeights weights) {
        return changes(colors, weights);
    }

    /** Returns whether the indirect light of any row changes as edge detection sees it; parameter as above. */
    boolean changesEdges(@Nullable RowWeights weights) {
        return changes(edges, weights);
    }

    private boolean changes(boolean @Nullable [] points, @Nullable RowWeights weights) {
        return isAll || points != null && requireNonNull(weights).touches(points);
    }
}
