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

    @Override
    public boolean equals(Object o) {
        return this == o || o instanceof Texture t && width == t.width && Arrays.equals(rgb, t.rgb);
    }

    @Override
    public int hashCode() {
        return 31 * width + height;
    }
}
