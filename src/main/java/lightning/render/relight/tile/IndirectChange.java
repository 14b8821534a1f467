package lightning.render.relight.tile;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Objects;
import lightning.render.gather.RowWeights;
import lightning.render.relight.plan.FilmUpdate;
import lightning.render.shading.IndirectLight;
import org.jspecify.annotations.Nullable;

/**
 * Gather points whose light an update changes. Rows far from these keep their colors.
 *
 * @param points for each film true for each gather point, then each reflection point, with other light; null if no point has
 * @param isAll  whether all rows change in all films
 */
record IndirectChange(boolean[] @Nullable [] points, boolean isAll) {
    static final IndirectChange NONE = new IndirectChange(new boolean[0][], false);
    private static final IndirectChange ALL = new IndirectChange(new boolean[0][], true);

    /** Compares the indirect light of two pictures, each null if there is none. */
    static IndirectChange between(@Nullable IndirectLight before, @Nullable IndirectLight after, FilmUpdate films) {
        if (before == null && after == null) {
            return NONE;
        }
        if (before == null || after == null || before.structure() != after.structure()) {
            return ALL;
        }
        boolean[] @Nullable [] points = new boolean[after.light().length][];
        for (int film = 0; film < points.length; film++) {
            float[][] was = films.origin()[film] < 0 ? null : before.light()[films.origin()[film]];
            float[][] is = after.light()[film];
            if (was != is) {
                points[film] =
                        changedPoints(was == null ? after.structure().noLight() : was, is == null ? after.structure().noLight() : is);
            }
        }
        return new IndirectChange(points, false);
    }

    /** Returns whether no point has other light. */
    boolean isNone() {
        return !isAll && Arrays.stream(points).allMatch(Objects::isNull);
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
     * Adds the films in which the indirect light of any row of a level changes.
     *
     * @param weights weights of the level after the update; null if there is no indirect light
     */
    void addChanged(@Nullable RowWeights weights, BitSet films) {
        for (int film = 0; film < points.length; film++) {
            if (points[film] != null && requireNonNull(weights).touches(requireNonNull(points[film]))) {
                films.set(film);
            }
        }
    }
}
