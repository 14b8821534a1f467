package lightning.scene;

import java.util.Arrays;

/**
 * A decoded picture: linear RGB in 0…1, rows from the top, never changed after construction. It multiplies a material's diffuse
 * colour, holds back a light, or tells heights or normals.
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

    /**
     * The luminance of four pixels mixed bilinearly, 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709), in double.
     *
     * @param across as {@link #mix} has it, and so is {@code along}
     */
    public double luminance(int x0, int y0, int x1, int y1, double across, double along) {
        double above = luminance(x0, y0) * (1 - across) + luminance(x1, y0) * across;
        double below = luminance(x0, y1) * (1 - across) + luminance(x1, y1) * across;
        return above * (1 - along) + below * along;
    }

    private double luminance(int x, int y) {
        int i = 3 * (y * width + x);
        return 0.2126 * rgb[i] + 0.7152 * rgb[i + 1] + 0.0722 * rgb[i + 2];
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
