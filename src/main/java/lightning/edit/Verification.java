package lightning.edit;

import java.util.concurrent.CancellationException;
import lightning.image.Difference;
import lightning.image.Film;
import lightning.scene.Scene;
import lightning.shading.Progress;
import lightning.shading.TraditionalTracer;
import lightning.shading.Workers;
import lightning.trace.Geometry;

/**
 * A picture beside a full trace of its scene.
 *
 * @param scene       what both show
 * @param picture     the picture, a copy
 * @param full        the full trace, mirrors and all
 * @param difference  of the two; where reflections are stale, they are in it
 * @param promised    of the picture and what its level promises: a full trace whose mirrors show what they last showed
 * @param fullTraceMs the full trace's time, milliseconds
 */
public record Verification(Scene scene, Film picture, Film full, Difference difference, Difference promised,
        double fullTraceMs) {

    /** What is to be verified. */
    record Request(Film picture, Scene scene, Scene mirrored, Geometry geometry) {
        /**
         * Traces in full.
         *
         * @throws CancellationException if {@code progress} asked to stop
         */
        Verification run(Workers workers, Progress progress) {
            long start = System.nanoTime();
            Film full = new TraditionalTracer(scene, geometry).trace(workers, progress).film();
            double milliseconds = (System.nanoTime() - start) / 1e6;
            Difference difference = Difference.of(picture, full);
            Difference promised = VisiblePart.same(scene, mirrored) ? difference : Difference.of(picture,
                    new TraditionalTracer(scene, mirrored, geometry).trace(workers, progress).film());
            return new Verification(scene, picture, full, difference, promised, milliseconds);
        }
    }
}
