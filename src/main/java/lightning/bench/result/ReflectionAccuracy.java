package lightning.bench.result;

import java.util.List;
import lightning.scene.PictureSettings;

/**
 * Time against error of blurred reflections on one scene, for several numbers of rays.
 *
 * @param width  pixels
 * @param height pixels
 * @param pixels number of pixels compared with brute force
 * @param points numbers of rays, ascending
 */
public record ReflectionAccuracy(String scene, int width, int height, int pixels, List<Point> points) {
    public ReflectionAccuracy {
        points = List.copyOf(points);
    }

    /**
     * One number of rays.
     *
     * @param points number of reflection points
     * @param time   time of the first pass
     * @param mean   mean relative error of what is reflected
     * @param shown  mean relative error of the colors of the same pixels
     * @param high   95th percentile of the errors
     * @param bias   difference of the sums of all pixels, relative to brute force
     */
    public record Point(int rays, int points, TimeSamples time, double mean, double shown, double high, double bias) {
        /** Returns whether it is the default. */
        public boolean usesDefault() {
            return rays == PictureSettings.REFLECTION_RAYS.initial();
        }
    }
}
