package lightning.relight.tile;

import lightning.effects.ViewEffects;
import lightning.relight.plan.Accuracy;
import lightning.relight.plan.Reflections;
import lightning.work.Workers;

/**
 * How a renderer works.
 *
 * @param threads how many threads, ≥ 1
 * @param view    which effects are shown; all of them in a picture
 */
public record Options(Accuracy accuracy, Reflections reflections, MirrorStorage storage, int threads, ViewEffects view) {
    /** Exact, mirrors and all; full rows, all processors. */
    public static final Options DEFAULT =
            new Options(Accuracy.EXACT, Reflections.CURRENT, MirrorStorage.FULL_ROWS, Workers.available());

    /** All effects. */
    public Options(Accuracy accuracy, Reflections reflections, MirrorStorage storage, int threads) {
        this(accuracy, reflections, storage, threads, ViewEffects.ALL);
    }

    public Options withAccuracy(Accuracy v) {
        return new Options(v, reflections, storage, threads, view);
    }

    public Options withReflections(Reflections v) {
        return new Options(accuracy, v, storage, threads, view);
    }

    public Options withStorage(MirrorStorage v) {
        return new Options(accuracy, reflections, v, threads, view);
    }

    public Options withThreads(int v) {
        return new Options(accuracy, reflections, storage, v, view);
    }

    public Options withView(ViewEffects v) {
        return new Options(accuracy, reflections, storage, threads, v);
    }
}
