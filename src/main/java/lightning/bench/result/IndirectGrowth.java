package lightning.bench.result;

import java.util.List;

/**
 * Costs of indirect light as a function of one dimension.
 *
 * @param along  dimension, as in {@code lights}
 * @param scene  short description of the scene
 * @param points points in the order of measurement
 */
public record IndirectGrowth(String along, String scene, List<Point> points) {
    public IndirectGrowth {
        points = List.copyOf(points);
    }

    /**
     * Costs at one point.
     *
     * @param at            number of lights, gather points, rays, objects, triangles or pixels
     * @param gatherPoints  number of gather points
     * @param surfels       number of surfels
     * @param bytesPerPixel additional bytes of the cache per pixel
     * @param first         time of the first pass
     * @param without       time of the first pass without indirect light
     * @param intensity     time of the update after a light's intensity changed
     * @param position      time of the update after a light moved
     */
    public record Point(long at, int gatherPoints, int surfels, double bytesPerPixel, TimeSamples first, TimeSamples without,
            TimeSamples intensity, TimeSamples position) {
        /** Returns the additional time of the first pass in milliseconds; not negative. */
        public double extraMs() {
            return Math.max(0, first.median() - without.median());
        }
    }
}
