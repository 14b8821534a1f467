package lightning.render.relight.paper;

import lightning.render.shading.WeightedLight;

/**
 * The paper's update after a change of color or intensity (§4.1): new over old weight, one factor for
 * each channel, by which all contributions are multiplied.
 */
record IntensityRatio(float red, float green, float blue) {
    static final IntensityRatio NONE = new IntensityRatio(1, 1, 1);

    /**
     * The ratio between two weights; not usable, see {@link #isUsable}, where an old weight is 0 and the new is not, or
     * so small that contributions made with it have lost digits: these are not even scaled by falloffs, though their
     * weight stays.
     */
    static IntensityRatio between(WeightedLight before, WeightedLight after) {
        return new IntensityRatio(ratio(before.red(), after.red()), ratio(before.green(), after.green()),
                ratio(before.blue(), after.blue()));
    }

    /** NaN where there is no usable ratio. */
    private static float ratio(float before, float after) {
        if (before == 0 && after == 0) {
            return 1;
        }
        float ratio = after / before;
        return before >= Float.MIN_NORMAL && ratio <= Float.MAX_VALUE ? ratio : Float.NaN;
    }

    /** Whether contributions can be scaled; if not, they must be computed anew (§4.1, the zero case). */
    boolean isUsable() {
        return red == red && green == green && blue == blue;
    }

    float channel(int c) {
        return c == 0 ? red : c == 1 ? green : blue;
    }
}
