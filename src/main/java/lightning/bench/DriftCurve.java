package lightning.bench;

import java.util.List;

/**
 * What becomes of a picture after many edits in a row, mirrors kept current.
 *
 * @param seed what the edits were drawn from
 */
public record DriftCurve(String scene, int width, int height, long seed, List<DriftPoint> points) {
    public DriftCurve {
        points = List.copyOf(points);
    }
}
