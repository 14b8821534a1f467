package lightning.scene;

import java.util.Arrays;

/**
 * A decoded picture that multiplies a material's diffuse colour: linear RGB in 0…1, rows from the
 * top, never changed after construction.
 */
public final class Texture {
    private final int width;
    private final int height;
    private final float[] rgb;

    /**
     * @param width  pixels, ≥ 1
     * @param height pixels, ≥ 1
     * @param rgb    linear values, {@code float[3 * width * height]}, row by row from the top; taken
     *               over, not copied
     */
    public Texture(int width, int height, float[] rgb) {
        if (width < 1 || height < 1 || rgb.length != 3 * width * height) {
            throw new IllegalArgumentException("a texture of " + width + "×" + height + " with " + rgb.length + " values");
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

    /** One channel (0 red, 1 green, 2 blue) of the pixel in column {@code x}, row {@code y}. */
    public float channel(int x, int y, int channel) {
        return rgb[3 * (y * width + x) + channel];
    }

    /**
     * Mixes four pixels bilinearly.
     *
     * @param across the share of column {@code x1} against {@code x0}, 0…1
     * @param along  the share of row {@code y1} against {@code y0}, 0…1
     * @param to     gets the linear RGB, {@code float[3]}
     */
    public void mix(int x0, int y0, int x1, int y1, double across, double along, float[] to) {
        float[] p = rgb;
        int upperLeft = 3 * (y0 * width + x0);
        int upperRight = 3 * (y0 * width + x1);
        int lowerLeft = 3 * (y1 * width + x0);
        int lowerRight = 3 * (y1 * width + x1);
        double left = 1 - across;
        double upper = 1 - along;
        for (int c = 0; c < 3; c++) {
            double above = p[upperLeft + c] * left + p[upperRight + c] * across;
            double below = p[lowerLeft + c] * left + p[lowerRight + c] * across;
            to[c] = (float) (above * upper + below * along);
        }
    }

    @Override
    public boolean equals(Object o) {
        return this == o || o instanceof Texture t && width == t.width && Arrays.equals(rgb, t.rgb);
    }

    @Override
    public int hashCode() {
        return 31 * width + height;
    }
}
