package lightning.format.jen.asset;

import java.util.stream.IntStream;
import lightning.format.image.ImageSource;
import lightning.scene.asset.EnvironmentDetail;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

/** Environment map from an image of any size. Of a large image, the light is computed from means of its pixels; all pixels are visible. */
final class EnvironmentMeans {
    /** Maximum number of pixels of a map: 8 Mi, 96 MiB. */
    private static final int MAX_PIXELS = 8 << 20;

    private final int width;
    private final int height;
    private final int step;
    private final int columns;
    private final int rows;
    private final float[] rgb;
    private final float[] pixel = new float[3];
    /** Null if the map has all pixels. */
    private final @Nullable EnvironmentDetail detail;
    /** Index of the first value of a pixel of the map, relative to its row, for each column of the image: divisions would be slow. */
    private final int[] columnStart;
    private int infiniteCount;
    /** Last row of the image, and the first value of its row of the map. */
    private int line = -1;
    private int first;

    /**
     * @param width  of the image, pixels
     * @param height of the image, pixels
     */
    EnvironmentMeans(int width, int height) {
        this.width = width;
        this.height = height;
        step = ImageSource.step(width, height, MAX_PIXELS);
        columns = Math.ceilDiv(width, step);
        rows = Math.ceilDiv(height, step);
        rgb = new float[3 * columns * rows];
        columnStart = IntStream.range(0, width).map(x -> 3 * (x / step)).toArray();
        detail = step > 1 ? new EnvironmentDetail(width, height, MAX_PIXELS) : null;
    }

    /** Returns the memory that reading the map of an image takes, in bytes. */
    static long bytes(int width, int height) {
        long pixels = (long) width * height;
        return (long) Integer.BYTES * width + 3L * Float.BYTES * Math.min(pixels, MAX_PIXELS)
                + (pixels > MAX_PIXELS ? EnvironmentDetail.bytes(pixels) : 0);
    }

    /**
     * Adds a pixel of the image. Negative values and those that are no numbers count as 0, larger ones as {@link SceneLimits#MAX_EMISSION}.
     *
     * @param from linear RGB, {@code float[3]}
     */
    void add(int x, int y, float[] from) {
        if (y != line) {
            line = y;
            first = 3 * columns * (y / step);
        }
        int at = first + columnStart[x];
        for (int c = 0; c < 3; c++) {
            infiniteCount += Float.isFinite(from[c]) ? 0 : 1;
            pixel[c] = ImageSource.limited(from[c]);
            rgb[at + c] += pixel[c];
        }
        if (detail != null) {
            detail.set(x, y, pixel);
        }
    }

    /** Returns the number of values that are infinite or no numbers. */
    int infiniteCount() {
        return infiniteCount;
    }

    /** Returns the map, which owns the values from now on. */
    EnvironmentMap map() {
        for (int i = 0; i < rgb.length; i++) {
            int column = i / 3 % columns;
            int row = i / 3 / columns;
            int count = (Math.min(width, (column + 1) * step) - column * step) * (Math.min(height, (row + 1) * step) - row * step);
            // Rounding of a sum may exceed the largest value.
            rgb[i] = Math.min(rgb[i] / count, (float) SceneLimits.MAX_EMISSION);
        }
        if (detail == null) {
            return new EnvironmentMap(columns, rows, rgb);
        }
        detail.freeze();
        return new EnvironmentMap(columns, rows, rgb, detail);
    }
}
