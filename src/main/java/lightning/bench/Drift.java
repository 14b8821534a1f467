package lightning.bench;

import java.util.List;

/**
 * What becomes of a picture after many edits in a row, mirrors kept current.
 *
 * @param seed what the edits were drawn from
 */
public record Drift(String scene, int width, int height, long seed, List<DriftPoint> points) {
    public Drift {
        points = List.copyOf(points);
    }
}
