package lightning.render.relight.tile;

import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.BranchSums;

/**
 * Notices that one light alone is edited again and again, as while it is dragged, or ambience and colors of materials: from the second time
 * on, the sums over the other lights are kept.
 */
public final class RepeatedEditDetector {
    /**
     * With fewer lights, adding them anew reads less memory than their sums take, and new falloffs take more time where cosines are not
     * kept alone than what is then read less: measured in docs/performance.md.
     */
    public static final int MIN_LIGHTS = 8;

    private BranchSums.Key key;

    /** Which light is edited again and again, in what the eye sees and in mirrors. */
    public record LevelDetectors(RepeatedEditDetector top, RepeatedEditDetector mirrors) {
        public LevelDetectors() {
            this(new RepeatedEditDetector(), new RepeatedEditDetector());
        }

        /** The plan with the keys of sums to use and to keep. */
        public UpdatePlan.Relight withKeys(UpdatePlan.Relight plan) {
            return plan.withKeys(nextKey(top, plan.top(), plan), plan.mirrors() == null ? null : nextKey(mirrors, plan.mirrors(), plan));
        }

        private static BranchSums.Key nextKey(RepeatedEditDetector repeated, LevelPlan level, UpdatePlan.Relight plan) {
            return repeated.nextKey(plan.shapes().isEmpty() ? level.singleChange() : LevelPlan.SEVERAL, level.layers().size());
        }

        /** Forgets which lights were edited last. */
        public void reset() {
            top.reset();
            mirrors.reset();
        }
    }

    /**
     * Hears of an update.
     *
     * @param light  the only light that it changes, {@link BranchSums.Key#NO_LIGHT}, or {@link LevelPlan#SEVERAL}
     * @param lights how many lights there are
     * @return the key of sums to use and to keep, or null
     */
    BranchSums.Key nextKey(int light, int lights) {
        if (light != LevelPlan.SEVERAL && lights >= MIN_LIGHTS && key != null && key.light() == light) {
            return key;
        }
        key = light == LevelPlan.SEVERAL ? null : new BranchSums.Key(light);
        return null;
    }

    /** Forgets which light was edited last. */
    void reset() {
        key = null;
    }
}
