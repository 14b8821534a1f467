package lightning.shading;

import lightning.trace.HitRows;

/**
 * The paper's update after a change of attenuation or dropoff (§4.2, §4.4): each row's new falloff over
 * its old one, both computed, because neither is stored. Holds scratch columns: one for each thread.
 */
final class AttenuationRatio {
    private final LightLanes lanes = new LightLanes();
    private final double[] before = new double[LightLanes.ROWS];
    private final double[] after = new double[LightLanes.ROWS];
    /** The ratio of each row; 1 where the row is not lit. */
    final float[] ratio = new float[LightLanes.ROWS];

    /**
     * Computes the ratio of each lit row.
     *
     * @return the largest ratio, or +∞ where an old falloff is 0 or too small to divide by
     */
    double compute(HitRows rows, Lamp from, Lamp to, byte[] states) {
        factors(rows, from, before);
        factors(rows, to, after);
        double largest = 1;
        for (int i = 0; i < rows.count; i++) {
            boolean lit = (states[i] & LightRows.STATE) == LightRows.LIT;
            double r = lit ? after[i] / before[i] : 1;
            ratio[i] = (float) r;
            largest = Math.max(largest, lit && !(before[i] >= Float.MIN_NORMAL) ? Double.POSITIVE_INFINITY : r);
        }
        return largest;
    }

    private void factors(HitRows rows, Lamp lamp, double[] to) {
        if (!lamp.type().hasPosition()) {
            java.util.Arrays.fill(to, 0, rows.count, 1);
            return;
        }
        lanes.aim(rows, lamp);
        if (lamp.type().hasCone()) {
            lanes.axisCosines(rows, lamp);
        }
        lanes.factors(rows, lamp, to);
    }
}
