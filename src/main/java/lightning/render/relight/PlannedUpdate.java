package lightning.render.relight;

import lightning.render.cache.PixelCache;
import lightning.render.relight.plan.UpdatePlan;
import lightning.scene.Scene;

/**
 * What a renderer is about to do, planned once for what it knew then: told before it begins, and then carried out by
 * {@link Renderer#render(PlannedUpdate, lightning.base.work.Progress)}.
 */
public final class PlannedUpdate {
    /** The scene wanted, as the view shows it. */
    final Scene target;
    /** Whether mirror images shall show it too. */
    final boolean updatesMirrors;
    /** What leads from the scene shown to the scene wanted. */
    final UpdatePlan difference;
    private final UpdatePlan update;
    /** What it goes on from: what is known, or an older picture; null for nothing. */
    final PixelCache base;
    private final PixelCache plannedFor;
    /** What planning took. */
    final long nanoseconds;

    /**
     * @param update as it is told: the difference, or where there is none the change of accuracy
     * @param base   what it goes on from, or null
     * @param known  what it was planned for, or null
     */
    PlannedUpdate(Scene target, boolean mirrors, UpdatePlan difference, UpdatePlan update, PixelCache base, PixelCache known,
            long nanoseconds) {
        this.target = target;
        this.updatesMirrors = mirrors;
        this.difference = difference;
        this.update = update;
        this.base = base;
        this.plannedFor = known;
        this.nanoseconds = nanoseconds;
    }

    /** What will be done. */
    public UpdatePlan update() {
        return update;
    }

    /** Whether it was planned for what is known now. */
    boolean isPlannedFor(PixelCache current) {
        return plannedFor == current;
    }
}
