package lightning.render.relight.tile;

import lightning.render.shading.BranchSums;

/**
 * Notices that one light alone is edited again and again, as while it is dragged, or ambience and colours of materials: from the second time
 * on, the sums over the other lights are kept.
 */
public final class RepeatedEdit {
    /**
     * With fewer lights, adding them anew reads less memory than their sums take, and new falloffs take more time where cosines are not
     * kept alone than what is then read less: measured in docs/performance.md.
     */
    public static final int LEAST_LIGHTS = 8;

    /** Stands for the place of a light where several are edited, or what lights fall on. */
    static final int MUCH = -2;

    private BranchSums.Key key;

    /**
     * Hears of an update.
     *
     * @param light  the only light that it changes, {@link BranchSums.Key#NO_LIGHT}, or {@link #MUCH}
     * @param lights how many lights there are
     * @return the key of sums to use and to keep, or null
     */
    BranchSums.Key next(int light, int lights) {
        if (light != MUCH && lights >= LEAST_LIGHTS && key != null && key.light() == light) {
            return key;
        }
        key = light == MUCH ? null : new BranchSums.Key(light);
        return null;
    }

    /** Forgets which light was edited last. */
    public void end() {
        key = null;
    }
}
