package lightning.format.jen.asset;

import lightning.format.hdr.HdrReader;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.value.SceneLimits;

/** Environment map from an image of any size: if it has too many pixels, each one of the map is the mean of some. */
final class EnvironmentMeans {
    private final int width;
    private final int height;
    private final int step;
    private final int columns;
    private final int rows;
    private final float[] rgb;
    private int infiniteCount;

    /**
     * @param width  of the image, pixels
     * @param height of the image, pixels
     */
    EnvironmentMeans(int width, int height) {
        this.width = width;
        this.height = height;
        step = TextureDecoder.step(width, height, HdrReader.MAX_PIXELS);
        columns = Math.ceilDiv(width, step);
        rows = Math.ceilDiv(height, step);
        rgb = new float[3 * columns * rows];
    }

    /** Returns whether the map has fewer pixels than the image. */
    boolean isReduced() {
        return step > 1;
    }

    /**
     * Adds a pixel of the image. Negative values and those that are no numbers count as 0, larger ones as {@link SceneLimits#MAX_EMISSION}.
     *
     * @param pixel linear RGB, {@code float[3]}
     */
    void add(int x, int y, float[] pixel) {
        int column = x / step;
        int row = y / step;
        int count = (Math.min(width, (column + 1) * step) - column * step) * (Math.min(height, (row + 1) * step) - row * step);
        for (int c = 0; c < 3; c++) {
            infiniteCount += Float.isFinite(pixel[c]) ? 0 : 1;
            rgb[3 * (row * columns + column) + c] += LinearTextureReader.limited(pixel[c]) / count;
        }
    }

    /** Returns the number of values that are infinite or no numbers. */
    int infiniteCount() {
        return infiniteCount;
    }

    /** Returns the map, which owns the values from now on. */
    EnvironmentMap map() {
        for (int i = 0; i < rgb.length; i++) {
            // Rounding of a sum may exceed the largest value.
            rgb[i] = Math.min(rgb[i], (float) SceneLimits.MAX_EMISSION);
        }
        return new EnvironmentMap(columns, rows, rgb);
    }
}
