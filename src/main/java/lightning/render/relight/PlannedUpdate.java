package lightning.render.relight;

import lightning.render.cache.PixelCache;
import lightning.render.relight.plan.UpdatePlan;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Planned update of a renderer, computed once for its current cache. It can be shown before {@link Renderer#render(PlannedUpdate,
 * lightning.base.work.Progress)} runs it.
 */
public final class PlannedUpdate {
    /** Target scene, as the view shows it. */
    final Scene target;
    /** True if mirror images must show it too. */
    final boolean updatesMirrors;
    /** Plan from the shown scene to the target scene. */
    final UpdatePlan difference;
    private final UpdatePlan update;
    /** Start of the update: the current cache or an older picture. */
    final @Nullable PixelCache base;
    private final @Nullable PixelCache plannedFor;
    /** Time taken by planning. */
    final long nanoseconds;

    /**
     * @param update plan to report: the difference, or the change of accuracy if there is none
     * @param base   start of the update
     * @param known  cache that it was planned for
     */
    PlannedUpdate(Scene target, boolean mirrors, UpdatePlan difference, UpdatePlan update, @Nullable PixelCache base,
            @Nullable PixelCache known, long nanoseconds) {
        this.target = target;
        this.updatesMirrors = mirrors;
        this.difference = difference;
        this.update = update;
        this.base = base;
        this.plannedFor = known;
        this.nanoseconds = nanoseconds;
    }

    /** Returns the plan. */
    public UpdatePlan update() {
        return update;
    }

    /** Returns whether it was planned for the current cache. */
    boolean isPlannedFor(@Nullable PixelCache current) {
        return plannedFor == current;
    }
}
