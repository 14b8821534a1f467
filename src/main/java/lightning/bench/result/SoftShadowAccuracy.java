package lightning.bench.result;

import java.util.List;
import lightning.scene.light.AreaShape;

/**
 * Time against error of area lights on one scene, for several numbers of samples.
 *
 * @param width   pixels
 * @param height  pixels
 * @param lights  number of area lights
 * @param points  numbers of samples, ascending
 */
public record SoftShadowAccuracy(String scene, int width, int height, int lights, List<Point> points) {
    public SoftShadowAccuracy {
        points = List.copyOf(points);
    }

    /**
     * One number of samples.
     *
     * @param time time of the first pass
     * @param mean mean relative error
     * @param high 95th percentile of the errors
     */
    public record Point(int samples, TimeSamples time, double mean, double high) {
        /** Returns whether it is the default. */
        public boolean usesDefault() {
            return samples == AreaShape.DEFAULT.samples();
        }
    }
}
