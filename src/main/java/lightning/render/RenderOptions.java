package lightning.render;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.base.work.HeapBudget;
import lightning.base.work.WorkerPool;
import lightning.render.engine.EngineChoice;
import lightning.render.engine.choice.Engines;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.RatioMethod;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.ExactMethod;
import lightning.render.relight.plan.UpdateMethod;
import lightning.scene.effects.ViewEffects;

/**
 * Options of a renderer.
 *
 * @param threads number of threads, ≥ 1
 * @param view    effects that are shown; all of them in a picture
 * @param memory  memory limit of a picture in bytes; a first pass that needs more is rejected
 * @param engines engine for each tile
 * @param fades   whether to expect many edits of weights in a row, as in an editor: scenes that keep no films otherwise then keep them
 */
@RecordBuilder
public record RenderOptions(Accuracy accuracy, ReflectionMode reflections, MirrorStorage storage, int threads, ViewEffects view,
        long memory,
        EngineChoice engines, boolean fades) implements RenderOptionsBuilder.With {
    /** Exact with current reflections, full rows, all processors. */
    public static final RenderOptions DEFAULT =
            new RenderOptions(Accuracy.EXACT, ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, WorkerPool.processorCount());

    /** Creates options with the memory of this Java process and its engines. */
    public RenderOptions(Accuracy accuracy, ReflectionMode reflections, MirrorStorage storage, int threads, ViewEffects view) {
        this(accuracy, reflections, storage, threads, view, HeapBudget.availableBytes(), Engines.CURRENT, true);
    }

    /** Creates options with all effects. */
    public RenderOptions(Accuracy accuracy, ReflectionMode reflections, MirrorStorage storage, int threads) {
        this(accuracy, reflections, storage, threads, ViewEffects.ALL);
    }

    /** Returns these options with the method of the default ones: exact, with current reflections and full rows. */
    public RenderOptions withDefaultMethod() {
        return withAccuracy(DEFAULT.accuracy).withReflections(DEFAULT.reflections).withStorage(DEFAULT.storage);
    }

    /** Returns these options with mirror images that keep showing an earlier scene until they are updated (paper §4.8). */
    public RenderOptions withReflectionsOnRequest() {
        return withReflections(ReflectionMode.STALE);
    }

    /** Returns whether mirror levels store rows and layers. */
    public boolean storesMirrorRows() {
        return storage.storesRows();
    }

    /** Returns these options with the storage of mirror levels that needs the least memory. */
    public RenderOptions withSmallestMirrors() {
        return withStorage(MirrorStorage.SMALLEST);
    }

    /** Returns whether every edit updates mirror images. */
    public boolean keepsReflectionsCurrent() {
        return reflections == ReflectionMode.CURRENT;
    }

    /** Returns the update method of this accuracy. */
    public UpdateMethod method() {
        return switch (accuracy) {
            case EXACT -> new ExactMethod();
            case RATIO -> new RatioMethod();
        };
    }
}
