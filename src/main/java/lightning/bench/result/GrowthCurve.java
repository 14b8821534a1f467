package lightning.bench.result;

import java.util.List;

/**
 * Times as a function of one dimension.
 *
 * @param along  {@code pixels}, {@code lights}, {@code shapes} or {@code depth}
 * @param scene  short description of the scene
 * @param points points in ascending order
 */
public record GrowthCurve(String along, String scene, List<GrowthPoint> points) {
    public GrowthCurve {
        points = List.copyOf(points);
    }
}
