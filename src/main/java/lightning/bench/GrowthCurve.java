package lightning.bench;

import java.util.List;

/**
 * How times grow with one thing.
 *
 * @param along  {@code pixels}, {@code lights}, {@code shapes} or {@code depth}
 * @param scene  what was traced, in a few words
 * @param points in rising order
 */
public record GrowthCurve(String along, String scene, List<GrowthPoint> points) {
    public GrowthCurve {
        points = List.copyOf(points);
    }
}
