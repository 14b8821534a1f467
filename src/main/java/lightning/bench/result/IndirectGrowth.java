package lightning.bench.result;

import java.util.List;
import java.util.function.ToDoubleFunction;

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

    /**
     * Returns the exponent of the power law that fits a value best, by least squares of the logarithms: 1 if it grows in proportion. NaN if
     * there are fewer than two points with positive values.
     */
    public double slope(ToDoubleFunction<Point> value) {
        List<double[]> logs = points.stream().filter(p -> p.at() > 0 && value.applyAsDouble(p) > 0)
                .map(p -> new double[] {Math.log(p.at()), Math.log(value.applyAsDouble(p))}).toList();
        double x = logs.stream().mapToDouble(p -> p[0]).average().orElse(Double.NaN);
        double y = logs.stream().mapToDouble(p -> p[1]).average().orElse(Double.NaN);
        double covariance = logs.stream().mapToDouble(p -> (p[0] - x) * (p[1] - y)).sum();
        double variance = logs.stream().mapToDouble(p -> (p[0] - x) * (p[0] - x)).sum();
        return variance > 0 ? covariance / variance : Double.NaN;
    }
}
