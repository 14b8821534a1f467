package lightning.render.relight.tile;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.base.work.HeapBudget;
import lightning.base.work.WorkerPool;
import lightning.render.engine.EngineChoice;
import lightning.render.engine.choice.Engines;
import lightning.render.relight.paper.RatioMethod;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.ReflectionMode;
import lightning.render.relight.plan.UpdateMethod;
import lightning.scene.effects.ViewEffects;

/**
 * How a renderer works.
 *
 * @param threads how many threads, ≥ 1
 * @param view    which effects are shown; all of them in a picture
 * @param memory  bytes that a picture may take; a first pass that takes more is refused
 * @param engines which engine makes which tile
 */
@RecordBuilder
public record RenderOptions(Accuracy accuracy, ReflectionMode reflections, MirrorStorage storage, int threads, ViewEffects view,
        long memory,
        EngineChoice engines) implements RenderOptionsBuilder.With {
    /** Exact, mirrors and all; full rows, all processors. */
    public static final RenderOptions DEFAULT =
            new RenderOptions(Accuracy.EXACT, ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, WorkerPool.processorCount());

    /** What memory there is in this Java, and its engines. */
    public RenderOptions(Accuracy accuracy, ReflectionMode reflections, MirrorStorage storage, int threads, ViewEffects view) {
        this(accuracy, reflections, storage, threads, view, HeapBudget.availableBytes(), Engines.CURRENT);
    }

    /** All effects. */
    public RenderOptions(Accuracy accuracy, ReflectionMode reflections, MirrorStorage storage, int threads) {
        this(accuracy, reflections, storage, threads, ViewEffects.ALL);
    }

    /** What carries out edits at this accuracy. */
    public UpdateMethod method() {
        return switch (accuracy) {
            case EXACT -> new ExactMethod();
            case RATIO -> new RatioMethod();
        };
    }
}
