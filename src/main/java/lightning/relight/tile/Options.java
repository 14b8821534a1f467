package lightning.relight.tile;

import lightning.effects.ViewEffects;
import lightning.relight.plan.Accuracy;
import lightning.relight.plan.Reflections;
import lightning.work.Memory;
import lightning.work.Workers;

/**
 * How a renderer works.
 *
 * @param threads how many threads, ≥ 1
 * @param view    which effects are shown; all of them in a picture
 * @param memory  bytes that a picture may take; a first pass that takes more is refused
 */
public record Options(Accuracy accuracy, Reflections reflections, MirrorStorage storage, int threads, ViewEffects view, long memory) {
    /** Exact, mirrors and all; full rows, all processors. */
    public static final Options DEFAULT =
            new Options(Accuracy.EXACT, Reflections.CURRENT, MirrorStorage.FULL_ROWS, Workers.available());

    /** What memory there is in this Java. */
    public Options(Accuracy accuracy, Reflections reflections, MirrorStorage storage, int threads, ViewEffects view) {
        this(accuracy, reflections, storage, threads, view, Memory.available());
    }

    /** All effects. */
    public Options(Accuracy accuracy, Reflections reflections, MirrorStorage storage, int threads) {
        this(accuracy, reflections, storage, threads, ViewEffects.ALL);
    }

    public Options withAccuracy(Accuracy v) {
        return new Options(v, reflections, storage, threads, view, memory);
    }

    public Options withReflections(Reflections v) {
        return new Options(accuracy, v, storage, threads, view, memory);
    }

    public Options withStorage(MirrorStorage v) {
        return new Options(accuracy, reflections, v, threads, view, memory);
    }

    public Options withThreads(int v) {
        return new Options(accuracy, reflections, storage, v, view, memory);
    }

    public Options withView(ViewEffects v) {
        return new Options(accuracy, reflections, storage, threads, v, memory);
    }

    public Options withMemory(long v) {
        return new Options(accuracy, reflections, storage, threads, view, v);
    }
}
