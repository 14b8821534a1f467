package lightning.scene.asset;

import java.lang.ref.SoftReference;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import lightning.base.file.ContentDigest;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.value.DomeRotation;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

/** Equirectangular map of linear radiance: its top is up, its middle −z, its right half x. Immutable. */
public final class EnvironmentMap implements ContentDigest.Content {
    /** Half-angle of bright parts that need not be divided, degrees. */
    private static final double COMPACT = 10;

    private final int width;
    private final int height;
    private final float[] rgb;
    private final Map<Integer, List<EnvironmentLight>> lights = new ConcurrentHashMap<>();
    private final Map<Integer, List<EnvironmentLight>> brightLights = new ConcurrentHashMap<>();
    private final @Nullable EnvironmentSun sun;
    /** All pixels of a larger image, of which this map has the means; null if it has all of them. */
    private final @Nullable EnvironmentDetail detail;
    /** Cosine of the sun's radius; 1 without a sun. */
    private final double sunCosine;
    private @Nullable Double limit;
    /** Its memory is larger than that of most maps, and it can be computed again. */
    private SoftReference<SmoothGrid> smoothGrid = new SoftReference<>(null);

    /**
     * @param rgb {@code float[3 * width * height]}, row by row from the top, each 0 … {@link SceneLimits#MAX_EMISSION}; owned by the map,
     *     not copied
     */
    public EnvironmentMap(int width, int height, float[] rgb) {
        this(width, height, rgb, null, null);
    }

    /**
     * Creates a map with a sun, which is its only bright part.
     *
     * @param rgb as without a sun, and without its light
     */
    public EnvironmentMap(int width, int height, float[] rgb, EnvironmentSun sun) {
        this(width, height, rgb, sun, null);
    }

    /**
     * Creates the map of a large image.
     *
     * @param rgb    as of a small image: its means
     * @param detail all of its pixels, which are visible
     */
    public EnvironmentMap(int width, int height, float[] rgb, EnvironmentDetail detail) {
        this(width, height, rgb, null, detail);
    }

    private EnvironmentMap(int width, int height, float[] rgb, @Nullable EnvironmentSun sun, @Nullable EnvironmentDetail detail) {
        if (width < 1 || height < 1 || rgb.length != 3 * width * height) {
            throw new IllegalArgumentException("a sky of " + width + "×" + height + " with " + rgb.length + " values");
        }
        this.width = width;
        this.height = height;
        this.rgb = rgb;
        this.sun = sun;
        this.detail = detail;
        sunCosine = sun == null ? 1 : Transform.cosDegrees(sun.radius());
    }

    /** Returns the memory of its pixels in bytes. */
    public long bytes() {
        return (long) Float.BYTES * rgb.length + (detail == null ? 0 : detail.bytes());
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

    /** Returns the linear values, {@code float[3 * width * height]}, row by row from the top; a copy. */
    public float[] values() {
        return rgb.clone();
    }

    /** Returns the luminance of a pixel, as {@link Rgb#luminance}. */
    public double luminance(int x, int y) {
        return new Rgb(channel(x, y, 0), channel(x, y, 1), channel(x, y, 2)).luminance();
    }

    /** Returns the luminance above which the light of a pixel belongs to the lights of {@link #brightLights}. */
    public synchronized double limit() {
        limit = limit != null ? limit : Double.valueOf(sun == null ? BrightParts.limit(this) : Double.POSITIVE_INFINITY);
        return limit;
    }

    /** Returns the solid angle of a pixel of a row, in steradians; all pixels together have 4π. */
    public double solidAngle(int y) {
        return 2 * Math.PI / width * (StrictMath.cos(Math.PI * y / height) - StrictMath.cos(Math.PI * (y + 1) / height));
    }

    /**
     * Returns the share of a pixel's light up to a luminance, 0 … 1.
     *
     * @param upTo luminance, ≥ 0
     */
    double smoothShare(int x, int y, double upTo) {
        double luminance = luminance(x, y);
        return luminance > upTo ? upTo / luminance : 1;
    }

    /** Returns the directional lights that represent the whole map ({@link MedianCut}); the same list for the same number. */
    public List<EnvironmentLight> lights(int maxLights) {
        return lights.computeIfAbsent(maxLights, n -> sun == null ? new MedianCut(this, 0).lights(n, 0)
                : Stream.concat(Stream.of(sun.toLight()), new MedianCut(this, 0).lights(n - 1, 0).stream()).toList());
    }

    /**
     * Returns the directional lights of its small bright parts: what exceeds {@link #limit}. One dark light if there is nothing.
     *
     * @param maxLights maximum number of lights
     */
    public List<EnvironmentLight> brightLights(int maxLights) {
        return sun != null ? List.of(sun.toLight())
                : brightLights.computeIfAbsent(maxLights, n -> new MedianCut(this, limit()).lights(n, COMPACT));
    }

    /** Returns the level of detail for pixels of a width in radians; −1 for this map. */
    public int detailLevel(double pixelAngle) {
        return detail == null ? -1 : detail.level(pixelAngle);
    }

    /** Computes the radiance from a direction at the map's own resolution. */
    public void radiance(double x, double y, double z, DomeRotation dome, double[] result) {
        radiance(x, y, z, dome, -1, result);
    }

    /**
     * Computes the radiance from a direction, bilinear between pixel centers; wraps at the sides and clamps at the top and bottom.
     *
     * @param dome   rotation of the map
     * @param level  a level of {@link #detailLevel}
     * @param result receives linear RGB, {@code double[3]}
     */
    public void radiance(double x, double y, double z, DomeRotation dome, int level, double[] result) {
        radiance(x, y, z, dome, level, Double.POSITIVE_INFINITY, result);
        if (sun != null && dome.toWorld().transformVector(sun.direction()).dot(new Vec3(x, y, z)) > sunCosine) {
            Rgb disc = sun.radiance();
            result[0] += disc.r();
            result[1] += disc.g();
            result[2] += disc.b();
        }
    }

    /** Computes the same without what belongs to {@link #brightLights}. */
    public void smoothRadiance(double x, double y, double z, DomeRotation dome, double[] result) {
        radiance(x, y, z, dome, -1, limit(), result);
    }

    private void radiance(double x, double y, double z, DomeRotation dome, int level, double upTo, double[] result) {
        if (dome.isUpright()) {
            radiance(u(x, z) + dome.rotation() / 360, v(y), level, upTo, result);
            return;
        }
        Transform m = dome.toWorld();
        radiance(u(m.m00() * x + m.m10() * y + m.m20() * z, m.m02() * x + m.m12() * y + m.m22() * z),
                v(m.m01() * x + m.m11() * y + m.m21() * z), level, upTo, result);
    }

    /** @param u place in the map, 0 … 1 from the left and wrapped, with {@code v} from the top */
    void smoothRadiance(double u, double v, double[] result) {
        radiance(u, v, -1, limit(), result);
    }

    // StrictMath gives the same bits on every machine; Math does not guarantee it.
    private static double u(double x, double z) {
        return 0.5 + StrictMath.atan2(x, -z) / (2 * Math.PI);
    }

    private static double v(double y) {
        return StrictMath.acos(Math.clamp(y, -1, 1)) / Math.PI;
    }

    private void radiance(double u, double v, int level, double upTo, double[] result) {
        EnvironmentDetail fine = level < 0 ? null : detail;
        int width = fine == null ? this.width : fine.width(level);
        int height = fine == null ? this.height : fine.height(level);
        double column = (u - Math.floor(u)) * width - 0.5;
        double row = Math.clamp(v * height - 0.5, 0, height - 1.0);
        double left = Math.floor(column);
        int x0 = Math.floorMod((int) left, width);
        int x1 = (x0 + 1) % width;
        int y0 = (int) row;
        int y1 = Math.min(y0 + 1, height - 1);
        double s = column - left;
        double t = row - y0;
        if (upTo == Double.POSITIVE_INFINITY) {
            for (int c = 0; c < 3; c++) {
                double above = channel(fine, level, x0, y0, c) * (1 - s) + channel(fine, level, x1, y0, c) * s;
                double below = channel(fine, level, x0, y1, c) * (1 - s) + channel(fine, level, x1, y1, c) * s;
                result[c] = above * (1 - t) + below * t;
            }
            return;
        }
        double topLeft = (1 - s) * (1 - t) * smoothShare(x0, y0, upTo);
        double topRight = s * (1 - t) * smoothShare(x1, y0, upTo);
        double bottomLeft = (1 - s) * t * smoothShare(x0, y1, upTo);
        double bottomRight = s * t * smoothShare(x1, y1, upTo);
        for (int c = 0; c < 3; c++) {
            result[c] = topLeft * channel(x0, y0, c) + topRight * channel(x1, y0, c) + bottomLeft * channel(x0, y1, c)
                    + bottomRight * channel(x1, y1, c);
        }
    }

    private double channel(@Nullable EnvironmentDetail fine, int level, int x, int y, int c) {
        return fine == null ? channel(x, y, c) : fine.channel(level, x, y, c);
    }

    /** Returns its smooth light on a grid. */
    public synchronized SmoothGrid smoothGrid() {
        SmoothGrid known = smoothGrid.get();
        if (known == null) {
            known = SmoothGrid.of(this);
            smoothGrid = new SoftReference<>(known);
        }
        return known;
    }

    @Override
    public boolean equals(Object o) {
        return this == o || o instanceof EnvironmentMap s && width == s.width && Arrays.equals(rgb, s.rgb) && Objects.equals(sun, s.sun)
                && Objects.equals(detail, s.detail);
    }

    @Override
    public void addTo(ContentDigest digest) {
        digest.add(width);
        digest.add(rgb);
        if (sun != null) {
            sun.addTo(digest);
        }
        if (detail != null) {
            detail.addTo(digest);
        }
    }

    @Override
    public int hashCode() {
        return 31 * width + height;
    }
}
