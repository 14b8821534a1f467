package lightning.render.image;

import java.util.Arrays;

/**
 * Histogram and waveform of a displayed picture's codes, by the curve and exposure of a view. False colors are not codes and count
 * as sRGB.
 *
 * @param histogram {@code int[3][256]}: pixels of each code, red, green and blue
 * @param waveform  {@code int[3][columns * 256]}: pixels of each code in each column, one column after the other
 * @param columns   columns of the waveform: those of the picture, or fewer that each combine several
 * @param pixels    number of pixels of the picture
 */
public record Scopes(int[][] histogram, int[][] waveform, int columns, long pixels) {
    /** Codes per channel. */
    public static final int CODES = 256;

    private static final int MAX_COLUMNS = 512;
    /** One in this many occurring codes may exceed the histogram's top. */
    private static final int CODES_PER_OUTLIER = 16;
    private static final int BACKGROUND = 0x16;
    private static final int BRIGHT = 0xE6;

    /** Counts a picture; about 10 ms on one thread for 1920×1080. */
    public static Scopes of(Film film, ViewTransform view) {
        int columns = Math.min(film.width(), MAX_COLUMNS);
        int[][] histogram = new int[3][CODES];
        int[][] waveform = new int[3][columns * CODES];
        int[] packed = view.forOutput().toPixels(film);
        for (int i = 0; i < packed.length; i++) {
            int column = (int) ((long) (i % film.width()) * columns / film.width());
            for (int c = 0; c < 3; c++) {
                int code = packed[i] >> 16 - 8 * c & 0xFF;
                histogram[c][code]++;
                waveform[c][column * CODES + code]++;
            }
        }
        return new Scopes(histogram, waveform, columns, packed.length);
    }

    /**
     * Draws the histogram as an image of 256 columns, black at the left, opaque 0xFFRRGGBB; overlapping channels add their colors.
     * Black, white and the most frequent sixteenth of the other occurring codes may be clipped at the top. Otherwise one even
     * background would flatten all other bars.
     *
     * @param height pixels
     */
    public int[] histogramPixels(int height) {
        int max = histogramTop();
        int[] to = new int[CODES * height];
        for (int y = 0; y < height; y++) {
            for (int code = 0; code < CODES; code++) {
                int rgb = 0xFF;
                for (int[] channel : histogram) {
                    // A code of any pixel is visible.
                    long bar = channel[code] == 0 ? 0 : Math.max(1, (long) channel[code] * height / max);
                    rgb = rgb << 8 | (height - y <= bar ? BRIGHT : BACKGROUND);
                }
                to[y * CODES + code] = rgb;
            }
        }
        return to;
    }

    /** Returns the pixel count at the top of the histogram's image. */
    private int histogramTop() {
        int[] bars = Arrays.stream(histogram).flatMapToInt(channel -> Arrays.stream(channel, 1, CODES - 1)).filter(n -> n > 0).sorted()
                .toArray();
        return bars.length == 0 ? 1 : bars[bars.length - 1 - bars.length / CODES_PER_OUTLIER];
    }

    /**
     * Draws the waveform as an image of {@link #columns} × 256 pixels, white at the top, opaque; brighter for more pixels with the
     * code.
     */
    public int[] waveformPixels() {
        // In a column whose codes are spread evenly over a sixteenth of all codes, each of them has half brightness.
        double even = (double) pixels / columns / (CODES / 16);
        int[] to = new int[columns * CODES];
        for (int x = 0; x < columns; x++) {
            for (int code = 0; code < CODES; code++) {
                int rgb = 0xFF;
                for (int[] channel : waveform) {
                    int count = channel[x * CODES + code];
                    rgb = rgb << 8 | (count == 0 ? BACKGROUND : (int) (0x50 + (BRIGHT - 0x50) * (count / (count + even))));
                }
                to[(CODES - 1 - code) * columns + x] = rgb;
            }
        }
        return to;
    }

    /** Returns the largest share of pixels, 0…1, with a code in one channel. */
    public double pixelShare(int code) {
        int max = 0;
        for (int[] channel : histogram) {
            max = Math.max(max, channel[code]);
        }
        return (double) max / pixels;
    }
}
