package lightning.bench.result;

import java.util.List;
import java.util.Optional;
import lightning.render.measure.IndirectError;
import lightning.scene.IndirectSettings;

/**
 * Time against error of indirect light on one scene, for several settings.
 *
 * @param width   pixels
 * @param height  pixels
 * @param pixels  number of sampled pixels that show a surface
 * @param rays    rays of the reference from each pixel
 * @param hitRays rays of the reference from each hit
 * @param without time of the first pass without indirect light
 * @param points  settings in order of measurement
 */
public record IndirectAccuracy(String scene, int width, int height, int pixels, int rays, int hitRays, TimeSamples without,
        List<Point> points) {
    public IndirectAccuracy {
        points = List.copyOf(points);
    }

    /**
     * One setting.
     *
     * @param time         time of the first pass
     * @param gatherPoints number of gather points
     * @param surfels      number of surfels
     */
    public record Point(int spacing, int rays, int bounces, TimeSamples time, int gatherPoints, int surfels, IndirectError error) {
        /** Returns whether spacing and rays are the default. */
        public boolean usesDefault() {
            return spacing == IndirectSettings.DEFAULT.spacing() && rays == IndirectSettings.DEFAULT.rays();
        }
    }

    /** Returns the settings with the default number of bounces. */
    public List<Point> grid() {
        return points.stream().filter(point -> point.bounces() == IndirectSettings.DEFAULT.bounces()).toList();
    }

    /** Returns the settings with the default spacing and rays, which differ in bounces. */
    public List<Point> byBounces() {
        return points.stream().filter(Point::usesDefault).sorted((a, b) -> a.bounces() - b.bounces()).toList();
    }

    /** Returns the point with default settings; empty if not measured. */
    public Optional<Point> initial() {
        return byBounces().stream().filter(point -> point.bounces() == IndirectSettings.DEFAULT.bounces()).findFirst();
    }

    /** Returns the additional time of the first pass in milliseconds; not negative. */
    public double extraMs(Point point) {
        return Math.max(0, point.time().median() - without.median());
    }
}
