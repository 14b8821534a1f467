package lightning.render.relight.paper;

import java.util.Arrays;
import lightning.render.shading.Lamp;
import lightning.render.shading.LightRows;
import lightning.render.shading.Shaping;
import lightning.render.shading.Terms;
import lightning.render.trace.HitRows;

/**
 * The paper's update after a change of attenuation or dropoff (§4.2, §4.4): each row's new falloff over
 * its old one, both computed, because neither is stored. Holds scratch columns: one for each thread.
 */
final class AttenuationRatio {
    private final Terms terms;
    private final double[] before = new double[Terms.ROWS];
    private final double[] after = new double[Terms.ROWS];
    /** The ratio of each row; 1 where the row is not lit. */
    final float[] ratio = new float[Terms.ROWS];

    private double least;

    AttenuationRatio(Terms terms) {
        this.terms = terms;
    }

    /** The least of all falloffs, old and new, of the rows computed last, but not below the least normal float. */
    double least() {
        return least;
    }

    /**
     * Computes the ratio of each lit row.
     *
     * @return whether there is one: not where an old falloff is 0 or too small to divide by
     */
    boolean compute(HitRows rows, Lamp from, Lamp to, byte[] states) {
        factors(rows, from, before);
        factors(rows, to, after);
        boolean usable = true;
        least = 1;
        for (int i = 0; i < rows.count; i++) {
            boolean lit = (states[i] & LightRows.STATE) == LightRows.LIT;
            ratio[i] = (float) (lit ? after[i] / before[i] : 1);
            usable &= !lit || before[i] >= Float.MIN_NORMAL;
            least = Math.min(least, lit ? Math.min(before[i], after[i]) : 1);
        }
        least = Math.max(least, Float.MIN_NORMAL);
        return usable;
    }

    private void factors(HitRows rows, Lamp lamp, double[] to) {
        if (!lamp.type().hasPosition()) {
            Arrays.fill(to, 0, rows.count, 1);
            return;
        }
        terms.aim(rows, lamp);
        if (lamp.hasCone()) {
            terms.aimCone(rows, lamp);
        }
        terms.factors(rows, lamp, to);
        Shaping doors = Shaping.of(lamp);
        if (doors != null) {
            doors.multiply(rows, to);
        }
    }
}
