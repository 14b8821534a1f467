package lightning.scene.asset;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import lightning.scene.value.SceneLimits;

/** Equirectangular map of linear radiance: its top is up, its middle −z, its right half x. Immutable. */
public final class EnvironmentMap {
    private final int width;
    private final int height;
    private final float[] rgb;
    private final Map<Integer, List<EnvironmentLight>> lights = new ConcurrentHashMap<>();

    /**
     * @param rgb {@code float[3 * width * height]}, row by row from the top, each 0 … {@link SceneLimits#MAX_EMISSION}; owned by the map,
     *     not copied
     */
    public EnvironmentMap(int width, int height, float[] rgb) {
        if (width < 1 || height < 1 || rgb.length != 3 * width * height) {
            throw new IllegalArgumentException("a sky of " + width + "×" + height + " with " + rgb.length + " values");
        }
        this.width = width;
        this.height = height;
        this.rgb = rgb;
    }

    public int width() {
        return width;
    }

    public int height() {
        return height;
    }

    /** Returns one channel (0 red, 1 green, 2 blue) of a pixel. */
    public float channel(int x, int y, int channel) {
        return rgb[3 * (y * width + x) + channel];
    }

    /** Returns the solid angle of a pixel of a row, in steradians; all pixels together have 4π. */
    public double solidAngle(int y) {
        return 2 * Math.PI / width * (StrictMath.cos(Math.PI * y / height) - StrictMath.cos(Math.PI * (y + 1) / height));
    }

    /** Returns the directional lights that represent the map ({@link MedianCut}); the same list for the same number. */
    public List<EnvironmentLight> lights(int maxLights) {
        return lights.computeIfAbsent(maxLights, n -> new MedianCut(this).lights(n));
    }

    /**
     * Computes the radiance from a direction, bilinear between pixel centers; wraps at the sides and clamps at the top and bottom.
     *
     * @param rotation rotation of the map about y in degrees, as {@code rotate} of a shape
     * @param result   receives linear RGB, {@code double[3]}
     */
    public void radiance(double x, double y, double z, double rotation, double[] result) {
        // StrictMath gives the same bits on every machine; Math does not guarantee it.
        double u = 0.5 + StrictMath.atan2(x, -z) / (2 * Math.PI) + rotation / 360;
        double v = StrictMath.acos(Math.clamp(y, -1, 1)) / Math.PI;
        double column = (u - Math.floor(u)) * width - 0.5;
        double row = Math.clamp(v * height - 0.5, 0, height - 1.0);
        double left = Math.floor(column);
        int x0 = Math.floorMod((int) left, width);
        int x1 = (x0 + 1) % width;
        int y0 = (int) row;
        int y1 = Math.min(y0 + 1, height - 1);
        double s = column - left;
        double t = row - y0;
        for (int c = 0; c < 3; c++) {
            double above = channel(x0, y0, c) * (1 - s) + channel(x1, y0, c) * s;
            double below = channel(x0, y1, c) * (1 - s) + channel(x1, y1, c) * s;
            result[c] = above * (1 - t) + below * t;
        }
    }

    @Override
    public boolean equals(Object o) {
        return this == o || o instanceof EnvironmentMap s && width == s.width && Arrays.equals(rgb, s.rgb);
    }

    @Override
    public int hashCode() {
        return 31 * width + height;
    }
}
