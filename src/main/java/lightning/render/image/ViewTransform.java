package lightning.render.image;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.math.BigDecimal;
import java.util.Arrays;
import java.util.Optional;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.render.image.aces.Aces2Table;

/**
 * View transform from a linear film to clamped display pixels. The film itself is never clamped.
 *
 * <p>Each channel becomes {@code curve(linear · 2^exposure)} clamped to 0…1, in 8 bits, correctly rounded. The gain {@code
 * 2^exposure} is rounded to float and so is the product; NaN counts as 0. {@link DisplayCurve#AGX},
 * {@link DisplayCurve#FILMIC} and {@link DisplayCurve#ACES2} mix the channels.
 *
 * @param exposure      stops, −64 to 64; one more doubles the brightness
 * @param lut           lookup table applied after the curve, if any; {@link DisplayCurve#LINEAR} is not clamped before it; ignored
 *                      for false colors
 * @param shaper        logarithm that replaces the curve before the lookup table, if any; that of the table by default; ignored without
 *                      a table
 * @param marksClipping true if clipped pixels are shown in {@link #CLIPPED_MARK} and {@link #BLACK_MARK}; ignored for false colors
 */
@RecordBuilder
public record ViewTransform(double exposure, DisplayCurve curve, Optional<CubeLut> lut, Optional<Log2Shaper> shaper,
        boolean marksClipping)
        implements ViewTransformBuilder.With {
    /** 0xRRGGBB: marks a pixel with a channel clipped at white. */
    public static final int CLIPPED_MARK = 0xFF00C8;
    /** 0xRRGGBB: marks a pixel that is shown as black. */
    public static final int BLACK_MARK = 0x0050FF;

    private static final double CODES = 255;
    private static final double CODES_16 = 65535;

    /** Largest absolute exposure in stops. */
    public static final double MAX_EXPOSURE = 64;

    /** sRGB; linear 1 is display white. */
    public static final ViewTransform DEFAULT = new ViewTransform(0);

    /** @throws RefusalException if {@code exposure} is NaN or outside −64…64 */
    public ViewTransform {
        if (!(Math.abs(exposure) <= MAX_EXPOSURE)) {
            throw new RefusalException("exposure must be from -64 to 64 stops, was " + exposure);
        }
    }

    /**
     * Creates a transform for an sRGB display.
     *
     * @throws RefusalException if {@code exposure} is NaN or outside −64…64
     */
    public ViewTransform(double exposure) {
        this(exposure, DisplayCurve.SRGB);
    }

    /**
     * Creates a transform without a lookup table and clipping marks.
     *
     * @throws RefusalException if {@code exposure} is NaN or outside −64…64
     */
    public ViewTransform(double exposure, DisplayCurve curve) {
        this(exposure, curve, Optional.empty(), Optional.empty(), false);
    }

    /** Returns the factor of linear values, {@code 2^exposure}. */
    public float gain() {
        return (float) StrictMath.pow(2, exposure);
    }

    /**
     * Returns the smallest linear value after exposure that is shown as each code, {@code float[256]}, 0 for code 0; empty if the transform
     * mixes channels.
     */
    public Optional<float[]> thresholds() {
        return mixesChannels() || curve == DisplayCurve.FALSE ? Optional.empty()
                : Optional.of(Arrays.copyOf(curve.table().threshold(), 256));
    }

    /** Returns the display code, 0 to 255, of one linear value, without the lookup table. */
    public int encode(float linear) {
        return curve.table().encode(linear * gain());
    }

    /**
     * Writes the 16-bit codes, 0 to 65535, of a linear pixel, rounded as the 8-bit codes are; without marks.
     *
     * @param to {@code short[]}: receives red, green and blue from {@code at} on
     */
    public void pack16(float red, float green, float blue, short[] to, int at) {
        float gain = gain();
        if (mixesChannels()) {
            double[] color = values(red * gain, green * gain, blue * gain);
            for (int c = 0; c < 3; c++) {
                to[at + c] = (short) code(color[c], CODES_16);
            }
        } else {
            to[at] = (short) curve.encode16(red * gain);
            to[at + 1] = (short) curve.encode16(green * gain);
            to[at + 2] = (short) curve.encode16(blue * gain);
        }
    }

    private boolean hasLut() {
        return lut.isPresent() && curve != DisplayCurve.FALSE;
    }

    /** Returns the linear value after exposure above which a channel is clamped: white of the curve, or the upper end of the logarithm. */
    public double white() {
        return usedShaper().map(Log2Shaper::white).orElse(curve.white());
    }

    private Optional<Log2Shaper> usedShaper() {
        return !hasLut() ? Optional.empty() : shaper.isPresent() ? shaper : lut.orElseThrow().log();
    }

    private boolean mixesChannels() {
        return hasLut() || curve.mixesChannels();
    }

    /** Returns the display values of linear values after exposure. */
    private double[] values(float red, float green, float blue) {
        Optional<Log2Shaper> used = usedShaper();
        if (used.isPresent()) {
            Log2Shaper log = used.get();
            return applyLut(log.encode(red), log.encode(green), log.encode(blue));
        }
        if (curve.mixesChannels()) {
            double[] color = switch (curve) {
                case AGX -> AgX.display(finite(red), finite(green), finite(blue));
                case FILMIC -> Filmic.display(red, green, blue);
                default -> Aces2Table.encoded(red, green, blue);
            };
            return hasLut() ? applyLut(color[0], color[1], color[2]) : color;
        }
        return applyLut(curve.value(red), curve.value(green), curve.value(blue));
    }

    private static double finite(float v) {
        return Float.isNaN(v) ? 0 : Math.clamp(v, -Float.MAX_VALUE, Float.MAX_VALUE);
    }

    private double[] applyLut(double red, double green, double blue) {
        double[] color = {red, green, blue};
        lut.orElseThrow().apply(color);
        return color;
    }

    private static int code(double v, double max) {
        // NaN is not above 0.
        return v > 0 ? (int) (max * Math.min(v, 1) + 0.5) : 0;
    }

    /** Returns the linear value, 0…1, that {@link #DEFAULT} shows as {@code code}, 0 to 255: the inverse of sRGB. */
    public static float linear(int code) {
        return Srgb.linear(code);
    }

    /** Returns the whole picture as {@code int[width * height]}, opaque 0xFFRRGGBB, the top row first. */
    public int[] toPixels(Film film) {
        int[] pixels = new int[Math.multiplyExact(film.width(), film.height())];
        for (int tile = 0; tile < film.tileCount(); tile++) {
            packTile(film, tile, pixels);
        }
        return pixels;
    }

    /**
     * Writes only the visible pixels of one tile into the whole picture's array, so that threads can pack different tiles at the
     * same time.
     *
     * @param tile   0 ≤ tile &lt; {@code film.tileCount()}
     * @param pixels {@code int[width * height]} of the whole film, as {@link #toPixels} returns it
     */
    public void packTile(Film film, int tile, int[] pixels) {
        packTile(film.red(tile), film.green(tile), film.blue(tile), tile % film.tilesX() * Film.TILE_SIZE,
                tile / film.tilesX() * Film.TILE_SIZE,
                film.width(), pixels);
    }

    /**
     * Writes the visible pixels of a tile that is not in a film yet.
     *
     * @param red    {@code float[1024]}, linear, as {@code green} and {@code blue}
     * @param left   the picture's column of the tile's first pixel, with {@code top} as its row
     * @param width  width of the picture
     * @param pixels {@code int[width * height]}, as {@link #toPixels} returns it
     */
    public void packTile(float[] red, float[] green, float[] blue, int left, int top, int width, int[] pixels) {
        boolean isFilmic = curve == DisplayCurve.FILMIC && !hasLut();
        if (curve == DisplayCurve.FALSE || mixesChannels() && !isFilmic || marksClipping) {
            packPixels(red, green, blue, left, top, width, pixels);
            return;
        }
        float gain = gain();
        CodeTable table = curve.table();
        float mixed = isFilmic ? Filmic.MAX_INDEPENDENT : Float.POSITIVE_INFINITY;
        int columns = Math.min(Film.TILE_SIZE, width - left);
        int rows = Math.min(Film.TILE_SIZE, pixels.length / width - top);
        for (int y = 0; y < rows; y++) {
            int from = y * Film.TILE_SIZE;
            int to = (top + y) * width + left;
            for (int x = 0; x < columns; x++) {
                float r = red[from + x] * gain;
                float g = green[from + x] * gain;
                float b = blue[from + x] * gain;
                pixels[to + x] = 0xFF000000 | (r > mixed || g > mixed || b > mixed ? Filmic.packed(r, g, b)
                        : table.encode(r) << 16 | table.encode(g) << 8 | table.encode(b));
            }
        }
    }

    private void packPixels(float[] red, float[] green, float[] blue, int left, int top, int width, int[] pixels) {
        int columns = Math.min(Film.TILE_SIZE, width - left);
        int rows = Math.min(Film.TILE_SIZE, pixels.length / width - top);
        float gain = gain();
        for (int y = 0; y < rows; y++) {
            for (int x = 0; x < columns; x++) {
                int i = y * Film.TILE_SIZE + x;
                pixels[(top + y) * width + left + x] = displayedPixel(red[i] * gain, green[i] * gain, blue[i] * gain);
            }
        }
    }

    /** Returns the display color of one linear pixel, opaque 0xFFRRGGBB. */
    public int pack(float red, float green, float blue) {
        float gain = gain();
        return displayedPixel(red * gain, green * gain, blue * gain);
    }

    /** Returns red, green and blue of the display color of one linear pixel, 0 to 255, {@code int[3]}. */
    public int[] displayed(float red, float green, float blue) {
        int packed = pack(red, green, blue);
        return new int[] {packed >> 16 & 0xFF, packed >> 8 & 0xFF, packed & 0xFF};
    }

    /** Returns the display color of values after exposure. */
    private int displayedPixel(float r, float g, float b) {
        if (curve == DisplayCurve.FALSE) {
            return 0xFF000000 | FalseColor.rgb(r, g, b);
        }
        int codes = hasLut() ? mixedCodes(r, g, b) : switch (curve) {
            case ACES2 -> Aces2Table.packed(r, g, b);
            case AGX -> AgX.packed(finite(r), finite(g), finite(b));
            case FILMIC -> Filmic.isIndependent(r, g, b) ? codes(r, g, b) : Filmic.packed(r, g, b);
            default -> codes(r, g, b);
        };
        if (marksClipping) {
            double white = white();
            boolean over = r > white || g > white || b > white;
            return 0xFF000000 | (over ? CLIPPED_MARK : codes == 0 ? BLACK_MARK : codes);
        }
        return 0xFF000000 | codes;
    }

    private int codes(float red, float green, float blue) {
        CodeTable table = curve.table();
        return table.encode(red) << 16 | table.encode(green) << 8 | table.encode(blue);
    }

    private int mixedCodes(float red, float green, float blue) {
        double[] color = values(red, green, blue);
        return code(color[0], CODES) << 16 | code(color[1], CODES) << 8 | code(color[2], CODES);
    }

    /** Returns the transform for a saved image by default: without false colors and marks, which are for viewing only. */
    public ViewTransform forOutput() {
        return new ViewTransform(exposure, curve == DisplayCurve.FALSE ? DisplayCurve.SRGB : curve, lut, shaper, false);
    }

    /** Returns a curve that shows every error that this view shows. The slope of a lookup table is unknown. */
    public DisplayCurve steepestCurve() {
        return hasLut() ? DisplayCurve.FILMIC : curve;
    }

    /** Returns a description, for example {@code Filmic, look.cube, +0.5 stops}. */
    public String description() {
        return usedShaper().map(Log2Shaper::text).orElse(curve.title())
                + lut.map(table -> ", " + Quote.path(table.file().getFileName())).orElse("") + (exposure == 0 ? ""
                        : ", " + (exposure > 0 ? "+" : "") + BigDecimal.valueOf(exposure).stripTrailingZeros().toPlainString() + " stops");
    }
}
