package lightning.relight;

import lightning.shading.Workers;

/**
 * How a renderer works.
 *
 * @param threads how many threads, ≥ 1
 */
public record Options(Accuracy accuracy, Reflections reflections, MirrorStorage storage, int threads) {
    /** Exact, reflections on demand as in the paper, full rows, all processors. */
    public static final Options DEFAULT =
            new Options(Accuracy.EXACT, Reflections.STALE, MirrorStorage.FULL_ROWS, Workers.available());

    public Options withAccuracy(Accuracy v) {
        return new Options(v, reflections, storage, threads);
    }

    public Options withReflections(Reflections v) {
        return new Options(accuracy, v, storage, threads);
    }

    public Options withStorage(MirrorStorage v) {
        return new Options(accuracy, reflections, v, threads);
    }

    public Options withThreads(int v) {
        return new Options(accuracy, reflections, storage, v);
    }
}
