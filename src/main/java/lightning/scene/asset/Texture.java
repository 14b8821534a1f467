package lightning.scene.asset;

import java.util.Arrays;
import lightning.base.file.ContentDigest;
import org.jspecify.annotations.Nullable;

/**
 * Decoded image: linear RGB in 0…1, rows from the top, immutable. Used as a color texture, gobo, bump map or normal map; on the face of a light,
 * values may be larger.
 */
public final class Texture implements ContentDigest.Content {
    private final int width;
    private final int height;
    /** Linear values; null if it stores codes. */
    private final float @Nullable [] rgb;
    private final byte @Nullable [] codes;
    private final float @Nullable [] values;
    /** Created on first use. */
    private volatile @Nullable SummedAreaTable areas;

    /**
     * Creates a texture of linear values.
     *
     * @param width  pixels, ≥ 1
     * @param height pixels, ≥ 1
     * @param rgb    linear values, {@code float[3 * width * height]}, row by row from the top; owned by the texture, not copied
     */
    public Texture(int width, int height, float[] rgb) {
        this(width, height, rgb.length, rgb, null, null);
    }

    /**
     * Creates a texture of 8-bit codes, as in most files: a quarter of the bytes.
     *
     * @param codes  {@code byte[3 * width * height]}, unsigned, row by row from the top; owned by the texture, not copied
     * @param values linear value of each code, {@code float[256]}; owned by the texture, not copied
     */
    public Texture(int width, int height, byte[] codes, float[] values) {
        this(width, height, values.length == 256 ? codes.length : -1, null, codes, values);
    }

    private Texture(int width, int height, int length, float @Nullable [] rgb, byte @Nullable [] codes, float @Nullable [] values) {
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

    /** Returns the number of pixels. */
    public long pixels() {
        return (long) width * height;
    }

    /** Returns the largest value. */
    public float max() {
        float max = 0;
        for (int i = 0; i < 3 * width * height; i++) {
            max = Math.max(max, value(i));
        }
        return max;
    }

    /** Returns a texture whose values are at most {@code limit}. */
    public Texture limited(float limit) {
        float[] limited = values();
        for (int i = 0; i < limited.length; i++) {
            limited[i] = Math.min(limited[i], limit);
        }
        return new Texture(width, height, limited);
    }

    /** Returns the linear values, {@code float[3 * width * height]}, row by row from the top; a copy. */
    public float[] values() {
        float[] copy = new float[3 * width * height];
        for (int i = 0; i < copy.length; i++) {
            copy[i] = value(i);
        }
        return copy;
    }

    /** Returns one channel (0 red, 1 green, 2 blue) of the pixel in column {@code x}, row {@code y}. */
    public float channel(int x, int y, int channel) {
        return value(3 * (y * width + x) + channel);
    }

    private float value(int i) {
        if (codes != null && values != null) {
            return values[codes[i] & 0xFF];
        }
        assert rgb != null;
        return rgb[i];
    }

    /**
     * Interpolates four pixels bilinearly.
     *
     * @param u      weight of column {@code x1} against {@code x0}, 0…1
     * @param v      weight of row {@code y1} against {@code y0}, 0…1
     * @param result receives linear RGB, {@code float[3]}
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

    /** Computes one channel of {@link #interpolate(int, int, int, int, double, double, float[])}. */
    public float interpolate(int x0, int y0, int x1, int y1, double u, double v, int channel) {
        double above = channel(x0, y0, channel) * (1 - u) + channel(x1, y0, channel) * u;
        double below = channel(x0, y1, channel) * (1 - u) + channel(x1, y1, channel) * u;
        return (float) (above * (1 - v) + below * v);
    }

    /**
     * Interpolates the luminance of four pixels, 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709), in double.
     *
     * @param u weight of column {@code x1}, as in {@link #interpolate}
     * @param v weight of row {@code y1}
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

    /** Returns the integrals of the image, which are computed on first use. */
    public SummedAreaTable areas() {
        SummedAreaTable known = areas;
        if (known == null) {
            known = new SummedAreaTable(this);
            areas = known;
        }
        return known;
    }

    /** Returns whether both have the same size and the same values, or the same codes with the same values. */
    @Override
    public boolean equals(@Nullable Object o) {
        return this == o || o instanceof Texture t && width == t.width && Arrays.equals(rgb, t.rgb) && Arrays.equals(codes, t.codes)
                && Arrays.equals(values, t.values);
    }

    @Override
    public void addTo(ContentDigest digest) {
        digest.add(width);
        digest.add(rgb);
        digest.add(codes);
        digest.add(values);
    }

    @Override
    public int hashCode() {
        return 31 * width + height;
    }
}
