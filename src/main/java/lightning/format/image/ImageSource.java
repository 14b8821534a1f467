package lightning.format.image;

import java.io.Closeable;
import java.io.IOException;
import lightning.render.image.Film;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureUsage;
import lightning.scene.value.SceneLimits;

/**
 * Opened image file. Its size and channels are known, and checked by {@link ImageFile}; its pixels are decoded on request, upright and in the working space, linear Rec. 709. A
 * decoder of a format extends it. Messages of its exceptions do not contain the file's name.
 */
public abstract class ImageSource implements Closeable {
    private static final float MAX_VALUE = (float) SceneLimits.MAX_EMISSION;

    /** Receives pixels. */
    @FunctionalInterface
    public interface PixelConsumer {
        /**
         * Receives a pixel.
         *
         * @param y   counted from the top
         * @param rgb red, green and blue, {@code float[3]}; reused
         */
        void accept(int x, int y, float[] rgb);
    }

    /** Pixels that are delivered once. */
    @FunctionalInterface
    interface Pixels {
        /**
         * Delivers every pixel once.
         *
         * @throws IOException if the file is damaged
         */
        void forEach(PixelConsumer sink) throws IOException;
    }

    /** Returns the width in pixels, as shown. */
    public abstract int width();

    /** Returns the height in pixels, as shown. */
    public abstract int height();

    /** Returns the number of pixels. */
    public final long pixelCount() {
        return (long) width() * height();
    }

    /** Returns whether the file contains codes of a display, which are converted to light by the curve of sRGB; else linear values. */
    public boolean isDisplayReferred() {
        return false;
    }

    /** Returns whether the image has alpha. */
    public boolean hasAlpha() throws IOException {
        return false;
    }

    /** Returns whether the file stores all bits of a float. */
    public boolean hasFullFloats() {
        return false;
    }

    /**
     * Finds damage and excessive work as far as that needs no memory for pixels: a damaged file shall not take the memory of the size that it
     * claims. Called once, after the size was checked.
     *
     * @throws IOException if the file is damaged
     */
    void check() throws IOException {}

    /**
     * Prepares the pixels; decoders of whole images decode them here.
     *
     * @param usage meaning of the samples
     * @throws IOException if the file is damaged
     */
    abstract Pixels pixels(TextureUsage usage) throws IOException;

    /**
     * Delivers every pixel once, in linear light.
     *
     * @throws IOException if the file is damaged
     */
    public final void read(PixelConsumer sink) throws IOException {
        pixels(TextureUsage.COLOR).forEach(sink);
    }

    /**
     * Decodes the image in linear light; values of a display are 0 … 1.
     *
     * @throws IOException if the file is damaged
     */
    public final Film film() throws IOException {
        Pixels pixels = pixels(TextureUsage.COLOR);
        Film film = Film.black(width(), height());
        pixels.forEach((x, y, rgb) -> {
            int tile = film.tileOf(x, y);
            int pixel = Film.pixelInTile(x, y);
            film.red(tile)[pixel] = rgb[0];
            film.green(tile)[pixel] = rgb[1];
            film.blue(tile)[pixel] = rgb[2];
        });
        return film;
    }

    /**
     * Decodes every n-th pixel of every n-th row, with values 0 … {@link SceneLimits#MAX_EMISSION}.
     *
     * @param usage meaning of the samples
     * @param step  n, ≥ 1
     * @throws IOException if the file is damaged
     */
    public final Texture texture(TextureUsage usage, int step) throws IOException {
        return texture(usage, step, 0);
    }

    /**
     * Decodes every n-th pixel of every n-th row, with values up to {@link SceneLimits#MAX_EMISSION}. What is not a number becomes 0.
     *
     * @param min smallest value
     * @throws IOException as above
     */
    public Texture texture(TextureUsage usage, int step, float min) throws IOException {
        int columns = Math.ceilDiv(width(), step);
        int rows = Math.ceilDiv(height(), step);
        Pixels pixels = pixels(usage);
        float[] values = new float[3 * columns * rows];
        pixels.forEach((x, y, rgb) -> {
            if (x % step == 0 && y % step == 0) {
                for (int c = 0; c < 3; c++) {
                    values[3 * (y / step * columns + x / step) + c] = limited(rgb[c], min);
                }
            }
        });
        return new Texture(columns, rows, values);
    }

    private static float limited(float value, float min) {
        return Float.isNaN(value) ? 0 : Math.clamp(value, min, MAX_VALUE);
    }

    /** Limits a value of light to 0 … {@link SceneLimits#MAX_EMISSION}; not a number becomes 0. */
    public static float limited(float value) {
        return limited(value, 0);
    }

    /** Returns the smallest step in which rows and columns of an image have at most {@code maxPixels} pixels. */
    public static int step(int width, int height, long maxPixels) {
        int step = 1;
        while ((long) Math.ceilDiv(width, step) * Math.ceilDiv(height, step) > maxPixels) {
            step++;
        }
        return step;
    }

    /** Returns the smallest step in which this image has at most {@code maxPixels} pixels. */
    public final int step(long maxPixels) {
        return step(width(), height(), maxPixels);
    }

    @Override
    public void close() throws IOException {}
}
