package lightning.bench;

import java.util.List;

/**
 * How times grow with one thing.
 *
 * @param along  {@code pixels}, {@code lights}, {@code shapes} or {@code depth}
 * @param scene  what was traced, in a few words
 * @param points in rising order
 */
public record Growth(String along, String scene, List<GrowthPoint> points) {
    public Growth {
        points = List.copyOf(points);
    }
}
