package lightning.render.relight.tile;

import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.composition.BranchSums;
import org.jspecify.annotations.Nullable;

/**
 * Detects repeated edits of one light, as during a drag, or of ambience and material colors. From the second edit on, the partial
 * sums of the other lights are cached, and terms of clear rows that no light changes.
 */
public final class RepeatedEditDetector {
    /**
     * Minimum number of lights for partial sums. With fewer, adding them again reads less memory than their sums need. Premultiplied layers also
     * make new falloffs slower by more than the cached sums save (measured in docs/performance.md).
     */
    public static final int MIN_LIGHTS = 8;

    private BranchSums.@Nullable Key key;

    /** Detectors for the first level and for the mirror levels. */
    public record LevelDetectors(RepeatedEditDetector top, RepeatedEditDetector mirrors) {
        public LevelDetectors() {
            this(new RepeatedEditDetector(), new RepeatedEditDetector());
        }

        /** Returns the plan with the keys of partial sums to use and to cache. */
        public UpdatePlan.Relight withKeys(UpdatePlan.Relight plan) {
            return plan.withKeys(nextKey(top, plan.top(), plan), plan.mirrors() == null ? null : nextKey(mirrors, plan.mirrors(), plan));
        }

        private static BranchSums.@Nullable Key nextKey(RepeatedEditDetector repeated, LevelPlan level, UpdatePlan.Relight plan) {
            return repeated.nextKey(plan.shapes().isEmpty() ? level.singleChange() : LevelPlan.SEVERAL);
        }

        /** Clears the last edited lights. */
        public void reset() {
            top.reset();
            mirrors.reset();
        }
    }

    /**
     * Records an update and returns the key for it.
     *
     * @param light  the only light that it changes, {@link BranchSums.Key#NO_LIGHT}, or {@link LevelPlan#SEVERAL}
     * @return the key of sums to use and to cache
     */
    BranchSums.@Nullable Key nextKey(int light) {
        if (light != LevelPlan.SEVERAL && key != null && key.light() == light) {
            return key;
        }
        key = light == LevelPlan.SEVERAL ? null : new BranchSums.Key(light);
        return null;
    }

    /** Clears the last edited light. */
    void reset() {
        key = null;
    }
}
