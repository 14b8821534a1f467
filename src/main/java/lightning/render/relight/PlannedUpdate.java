package lightning.render.relight;

import lightning.render.cache.PixelCache;
import lightning.render.relight.plan.UpdatePlan;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Planned update of a renderer, computed once for its current cache. It can be shown before {@link Renderer#render(PlannedUpdate,
 * lightning.base.work.Progress)} runs it.
 *
 * @param target         target scene, as the view shows it
 * @param updatesMirrors true if mirror images must show it too
 * @param difference     plan from the shown scene to the target scene
 * @param update         plan to report: the difference, or the change of accuracy if there is none
 * @param base           start of the update
 * @param plannedFor     cache that it was planned for
 * @param nanoseconds    time taken by planning
 */
public record PlannedUpdate(Scene target, boolean updatesMirrors, UpdatePlan difference, UpdatePlan update, @Nullable PixelCache base,
        @Nullable PixelCache plannedFor, long nanoseconds) {
    /** Returns whether it was planned for the current cache. */
    boolean isPlannedFor(@Nullable PixelCache current) {
        return plannedFor == current;
    }
}
