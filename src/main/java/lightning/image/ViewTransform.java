package lightning.image;

import java.math.BigDecimal;

/**
 * How a linear film becomes display pixels: clamped, which a film never is.
 *
 * <p>Each channel becomes {@code curve(linear · 2^exposure)} cut to 0…1, in 8 bits, correctly rounded. The gain
 * {@code 2^exposure} is rounded to float and so is the product; NaN counts as 0.
 *
 * @param exposure stops, −64 to 64; one more doubles the brightness
 */
public record ViewTransform(double exposure, DisplayCurve curve) {

    /** The largest absolute exposure, in stops. */
    public static final double MAX_EXPOSURE = 64;

    /** sRGB; linear white 1 is display white. */
    public static final ViewTransform DEFAULT = new ViewTransform(0);

    /** @throws IllegalArgumentException if {@code exposure} is NaN or outside −64…64 */
    public ViewTransform {
        if (!(Math.abs(exposure) <= MAX_EXPOSURE)) {
            throw new IllegalArgumentException("exposure must be from -64 to 64 stops, was " + exposure);
        }
    }

    /**
     * For an sRGB display.
     *
     * @throws IllegalArgumentException if {@code exposure} is NaN or outside −64…64
     */
    public ViewTransform(double exposure) {
        this(exposure, DisplayCurve.SRGB);
    }

    public ViewTransform withExposure(double stops) {
        return new ViewTransform(stops, curve);
    }

    public ViewTransform withCurve(DisplayCurve v) {
        return new ViewTransform(exposure, v);
    }

    /** The factor on linear values, {@code 2^exposure}. */
    public float gain() {
        return (float) StrictMath.pow(2, exposure);
    }

    /** The display code, 0 to 255, of one linear value. */
    public int encode(float linear) {
        return curve.table().encode(linear * gain());
    }

    /** The code of 16 bits, 0 to 65535, of one linear value: rounded as that of 8 bits is. */
    public int encodeDeep(float linear) {
        return curve.encodeDeep(linear * gain());
    }

    /** The linear value, 0…1, that {@link #DEFAULT} shows as {@code code}, 0 to 255: the inverse of sRGB. */
    public static float linear(int code) {
        return Srgb.linear(code);
    }

    /** The whole picture as {@code int[width * height]}, opaque 0xFFRRGGBB, the top row first. */
    public int[] toPixels(Film film) {
        int[] pixels = new int[Math.multiplyExact(film.width(), film.height())];
        for (int tile = 0; tile < film.tileCount(); tile++) {
            packTile(film, tile, pixels);
        }
        return pixels;
    }

    /**
     * Writes the visible pixels of one tile into the picture that holds them all, and nothing else, so that different
     * tiles may be packed at the same time.
     *
     * @param tile   0 ≤ tile &lt; {@code film.tileCount()}
     * @param pixels {@code int[width * height]} of the whole film, as {@link #toPixels} gives it
     */
    public void packTile(Film film, int tile, int[] pixels) {
        packTile(film.red(tile), film.green(tile), film.blue(tile), tile % film.tilesX() * Film.TILE, tile / film.tilesX() * Film.TILE,
                film.width(), pixels);
    }

    /**
     * Writes the visible pixels of a tile that is in no film yet.
     *
     * @param red    {@code float[1024]}, linear; likewise {@code green} and {@code blue}
     * @param left   the picture's column of the tile's first; likewise {@code top}
     * @param width  the picture's
     * @param pixels {@code int[width * height]}, as {@link #toPixels} gives it
     */
    public void packTile(float[] red, float[] green, float[] blue, int left, int top, int width, int[] pixels) {
        if (curve == DisplayCurve.FALSE) {
            packStops(red, green, blue, left, top, width, pixels);
            return;
        }
        float gain = gain();
        CodeTable table = curve.table();
        int columns = Math.min(Film.TILE, width - left);
        int rows = Math.min(Film.TILE, pixels.length / width - top);
        for (int y = 0; y < rows; y++) {
            int from = y * Film.TILE;
            int to = (top + y) * width + left;
            for (int x = 0; x < columns; x++) {
                pixels[to + x] = 0xFF000000
                        | table.encode(red[from + x] * gain) << 16
                        | table.encode(green[from + x] * gain) << 8
                        | table.encode(blue[from + x] * gain);
            }
        }
    }

    private void packStops(float[] red, float[] green, float[] blue, int left, int top, int width, int[] pixels) {
        int columns = Math.min(Film.TILE, width - left);
        int rows = Math.min(Film.TILE, pixels.length / width - top);
        for (int y = 0; y < rows; y++) {
            for (int x = 0; x < columns; x++) {
                int i = y * Film.TILE + x;
                pixels[(top + y) * width + left + x] = pack(red[i], green[i], blue[i]);
            }
        }
    }

    /** One pixel of linear values as it is displayed, opaque 0xFFRRGGBB. */
    public int pack(float red, float green, float blue) {
        float gain = gain();
        if (curve == DisplayCurve.FALSE) {
            return 0xFF000000 | FalseColor.of(red * gain, green * gain, blue * gain);
        }
        CodeTable table = curve.table();
        return 0xFF000000 | table.encode(red * gain) << 16 | table.encode(green * gain) << 8 | table.encode(blue * gain);
    }

    /** What a saved picture is shown by where nobody asked for another: stops are for looking alone. */
    public ViewTransform ofPicture() {
        return curve == DisplayCurve.FALSE ? withCurve(DisplayCurve.SRGB) : this;
    }

    /** As in {@code Filmic (Hable), +0.5 stops}. */
    public String text() {
        return curve.title() + (exposure == 0 ? ""
                : ", " + (exposure > 0 ? "+" : "") + BigDecimal.valueOf(exposure).stripTrailingZeros().toPlainString() + " stops");
    }
}
