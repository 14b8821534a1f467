package lightning.bench.result;

import java.util.List;

/**
 * Image error after many edits in a row, with current reflections.
 *
 * @param seed random seed of the edits
 */
public record DriftCurve(String scene, int width, int height, long seed, List<DriftPoint> points) {
    public DriftCurve {
        points = List.copyOf(points);
    }
}
