package lightning.accuracy;

import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.scene.Scene;
import lightning.shading.Progress;
import lightning.shading.TraditionalTracer;
import lightning.shading.Workers;
import lightning.trace.Geometry;

/** How long a full trace takes once Java has warmed up to it: what savings are savings of. */
public final class FullTraceTime {
    private static final int REPETITIONS = 5;

    private FullTraceTime() {}

    /**
     * Traces a scene in full, again and again.
     *
     * @param geometry the scene's, with its tree of boxes, which the trace gets for free
     * @param progress hears of finished traces
     * @throws CancellationException if {@code progress} asked to stop
     */
    public static Timing measure(Scene scene, Geometry geometry, Workers workers, Progress progress) {
        var tracer = new TraditionalTracer(scene, geometry);
        Turns.Turn<RuntimeException> trace = () -> Turns.time(() -> tracer.trace(workers, progress.silent()));
        return new Turns(REPETITIONS).take(List.of(trace), progress).getFirst();
    }
}
