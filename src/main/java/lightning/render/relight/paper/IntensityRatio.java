package lightning.render.relight.paper;

import lightning.render.shading.WeightedLight;

/** The paper's update after a change of color or intensity (§4.1): new over old weight, one factor per channel for all contributions. */
record IntensityRatio(float red, float green, float blue) {
    static final IntensityRatio NONE = new IntensityRatio(1, 1, 1);

    /**
     * Returns the ratio between the weights of a light without gains. It is not usable, see {@link #isUsable}, if an old weight is 0 and the new one is not,
     * or if an old weight is so small that its contributions have lost digits. Falloffs do not scale such contributions either.
     */
    static IntensityRatio between(WeightedLight before, WeightedLight after) {
        return new IntensityRatio(ratio(before.diffuse().red(), after.diffuse().red()),
                ratio(before.diffuse().green(), after.diffuse().green()), ratio(before.diffuse().blue(), after.diffuse().blue()));
    }

    /** Returns NaN if there is no usable ratio. */
    private static float ratio(float before, float after) {
        if (before == 0 && after == 0) {
            return 1;
        }
        float ratio = after / before;
        return before >= Float.MIN_NORMAL && ratio <= Float.MAX_VALUE ? ratio : Float.NaN;
    }

    /** Returns whether contributions can be scaled; if not, they must be recomputed (§4.1, the zero case). */
    boolean isUsable() {
        return red == red && green == green && blue == blue;
    }

    float channel(int c) {
        return c == 0 ? red : c == 1 ? green : blue;
    }
}
