package lightning.render.image;

import java.util.Arrays;

/**
 * How the codes of a displayed picture are spread: how many pixels have each (a histogram), and how many of each column have it (a
 * waveform). By the curve and exposure of a view; false colors are no codes, and count as sRGB.
 *
 * @param histogram {@code int[3][256]}: pixels of each code, red, green and blue
 * @param waveform  {@code int[3][columns * 256]}: the same of each column, one column after the other
 * @param columns   of the waveform: those of the picture, or fewer that each stand for several
 * @param pixels    of the picture
 */
public record Scopes(int[][] histogram, int[][] waveform, int columns, long pixels) {
    /** Codes of a channel. */
    public static final int CODES = 256;

    private static final int MAX_COLUMNS = 512;
    /** Of so many codes that occur one may rise above the histogram. */
    private static final int CODES_PER_OUTLIER = 16;
    private static final int BACKGROUND = 0x16;
    private static final int BRIGHT = 0xE6;

    /** Counts a picture: some 10 ms of one thread for 1920×1080. */
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
     * The histogram as a picture of 256 columns, black at the left, opaque 0xFFRRGGBB; where channels overlap their colors add. Black,
     * white and one in sixteen of the other codes that occur, the most frequent ones, may be cut off at the top: one even background would
     * press all else into the ground line.
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
                    // A code that any pixel has is seen.
                    long bar = channel[code] == 0 ? 0 : Math.max(1, (long) channel[code] * height / max);
                    rgb = rgb << 8 | (height - y <= bar ? BRIGHT : BACKGROUND);
                }
                to[y * CODES + code] = rgb;
            }
        }
        return to;
    }

    /** How many pixels reach the top of the histogram's picture. */
    private int histogramTop() {
        int[] bars = Arrays.stream(histogram).flatMapToInt(channel -> Arrays.stream(channel, 1, CODES - 1)).filter(n -> n > 0).sorted()
                .toArray();
        return bars.length == 0 ? 1 : bars[bars.length - 1 - bars.length / CODES_PER_OUTLIER];
    }

    /** The waveform as a picture of {@link #columns} × 256 pixels, white at the top, opaque; brighter where more pixels have the code. */
    public int[] waveformPixels() {
        // Of a column whose codes are spread evenly over a sixteenth of all, every one is half bright.
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

    /** The largest share of pixels, 0…1, that have a code in one channel. */
    public double pixelShare(int code) {
        int max = 0;
        for (int[] channel : histogram) {
            max = Math.max(max, channel[code]);
        }
        return (double) max / pixels;
    }
}
