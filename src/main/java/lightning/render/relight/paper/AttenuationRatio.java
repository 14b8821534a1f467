package lightning.render.relight.paper;

import java.util.Arrays;
import lightning.render.shading.AngularMask;
import lightning.render.shading.LightSource;
import lightning.render.shading.TermKernel;
import lightning.render.shading.layer.LightRows;
import lightning.render.trace.HitRows;

/**
 * The paper's update after a change of attenuation or dropoff (§4.2, §4.4): each row's new falloff over its old one. Both are
 * computed, because neither is stored. Holds scratch columns: use one instance per thread.
 */
final class AttenuationRatio {
    private final TermKernel terms;
    private final double[] before = new double[TermKernel.MAX_ROWS];
    private final double[] after = new double[TermKernel.MAX_ROWS];
    /** Ratio of each row; 1 for unlit rows. */
    final float[] ratio = new float[TermKernel.MAX_ROWS];

    private double minFalloff;

    AttenuationRatio(TermKernel terms) {
        this.terms = terms;
    }

    /** Returns the smallest old or new falloff of the last rows, at least the smallest normal float. */
    double minFalloff() {
        return minFalloff;
    }

    /**
     * Computes the ratio of each lit row.
     *
     * @return false if an old falloff is 0 or too small to divide by
     */
    boolean compute(HitRows rows, LightSource from, LightSource to, byte[] states) {
        factors(rows, from, before);
        factors(rows, to, after);
        boolean usable = true;
        minFalloff = 1;
        for (int i = 0; i < rows.count; i++) {
            boolean lit = (states[i] & LightRows.STATE_MASK) == LightRows.LIT;
            ratio[i] = (float) (lit ? after[i] / before[i] : 1);
            usable &= !lit || before[i] >= Float.MIN_NORMAL;
            minFalloff = Math.min(minFalloff, lit ? Math.min(before[i], after[i]) : 1);
        }
        minFalloff = Math.max(minFalloff, Float.MIN_NORMAL);
        return usable;
    }

    private void factors(HitRows rows, LightSource source, double[] to) {
        if (!source.type().hasPosition()) {
            Arrays.fill(to, 0, rows.count, 1);
        } else {
            terms.aim(rows, source);
            if (source.hasCone()) {
                terms.computeConeCosines(rows, source);
            }
            terms.unroundedFalloffs(rows, source, to);
        }
        AngularMask mask = AngularMask.of(source);
        if (mask != null) {
            mask.multiply(rows, to);
        }
    }
}
