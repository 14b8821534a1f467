package lightning.scene;

import java.util.Arrays;

/**
 * A decoded picture: linear RGB in 0…1, rows from the top, never changed after construction. It multiplies a material's diffuse
 * color, holds back a light, or tells heights or normals.
 */
public final class Texture {
    private final int width;
    private final int height;
    /** Linear values, or nothing where there are codes. */
    private final float[] rgb;
    private final byte[] codes;
    private final float[] values;

    /**
     * Of linear values.
     *
     * @param width  pixels, ≥ 1
     * @param height pixels, ≥ 1
     * @param rgb    linear values, {@code float[3 * width * height]}, row by row from the top; taken
     *               over, not copied
     */
    public Texture(int width, int height, float[] rgb) {
        this(width, height, rgb.length, rgb, null, null);
    }

    /**
     * Of codes of 8 bits, as most files have: a quarter of the bytes.
     *
     * @param codes  {@code byte[3 * width * height]}, each from 0 to 255 without a sign, row by row from the top; taken over, not copied
     * @param values the linear value of each code, {@code float[256]}; taken over, not copied
     */
    public Texture(int width, int height, byte[] codes, float[] values) {
        this(width, height, values.length == 256 ? codes.length : -1, null, codes, values);
    }

    private Texture(int width, int height, int length, float[] rgb, byte[] codes, float[] values) {
        if (width < 1 || height < 1 || length != 3 * width * height) {
            throw new IllegalArgumentException("a texture of " + width + "×" + height + " with " + length + " values");
        }
        this.width = width;
        this.height = height;
        this.rgb = rgb;
        this.codes = codes;
        this.values = values;
    }

    public int width() {
        return width;
    }

    public int height() {
        return height;
    }

    /** One channel (0 red, 1 green, 2 blue) of the pixel in column {@code x}, row {@code y}. */
    public float channel(int x, int y, int channel) {
        return value(3 * (y * width + x) + channel);
    }

    private float value(int i) {
        return codes != null ? values[codes[i] & 0xFF] : rgb[i];
    }

    /**
     * Mixes four pixels bilinearly.
     *
     * @param u the share of column {@code x1} against {@code x0}, 0…1
     * @param v  the share of row {@code y1} against {@code y0}, 0…1
     * @param result     gets the linear RGB, {@code float[3]}
     */
    public void interpolate(int x0, int y0, int x1, int y1, double u, double v, float[] result) {
        int upperLeft = 3 * (y0 * width + x0);
        int upperRight = 3 * (y0 * width + x1);
        int lowerLeft = 3 * (y1 * width + x0);
        int lowerRight = 3 * (y1 * width + x1);
        double left = 1 - u;
        double upper = 1 - v;
        for (int c = 0; c < 3; c++) {
            double above = value(upperLeft + c) * left + value(upperRight + c) * u;
            double below = value(lowerLeft + c) * left + value(lowerRight + c) * u;
            result[c] = (float) (above * upper + below * v);
        }
    }

    /** One channel of {@link #interpolate(int, int, int, int, double, double, float[])}. */
    public float interpolate(int x0, int y0, int x1, int y1, double u, double v, int channel) {
        double above = channel(x0, y0, channel) * (1 - u) + channel(x1, y0, channel) * u;
        double below = channel(x0, y1, channel) * (1 - u) + channel(x1, y1, channel) * u;
        return (float) (above * (1 - v) + below * v);
    }

    /**
     * The luminance of four pixels mixed bilinearly, 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709), in double.
     *
     * @param u as {@link #interpolate} has it, and so is {@code v}
     */
    public double luminance(int x0, int y0, int x1, int y1, double u, double v) {
        double above = luminance(x0, y0) * (1 - u) + luminance(x1, y0) * u;
        double below = luminance(x0, y1) * (1 - u) + luminance(x1, y1) * u;
        return above * (1 - v) + below * v;
    }

    private double luminance(int x, int y) {
        int i = 3 * (y * width + x);
        return 0.2126 * value(i) + 0.7152 * value(i + 1) + 0.0722 * value(i + 2);
    }

    /** Whether both have the same size and were made of the same values, or of the same codes with the same values. */
    @Override
    public boolean equals(Object o) {
        return this == o || o instanceof Texture t && width == t.width && Arrays.equals(rgb, t.rgb) && Arrays.equals(codes, t.codes)
                && Arrays.equals(values, t.values);
    }

    @Override
    public int hashCode() {
        return 31 * width + height;
    }
}
