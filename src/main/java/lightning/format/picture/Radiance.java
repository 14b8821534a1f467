package lightning.format.picture;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import lightning.render.image.Film;
import lightning.render.image.Pixels;

/**
 * Radiance's picture, {@code .hdr}: for each pixel three mantissas of 8 bits that share an exponent (Ward, Real Pixels, Graphics Gems
 * II, 1991), rounded to the nearest, with runs in each of the four columns of a line. What is below 0 or no number is 0.
 */
final class Radiance {
    /** Lines of other widths have no runs. */
    private static final int LEAST_WIDTH = 8;
    private static final int MOST_WIDTH = 0x7FFF;
    private static final int LONGEST_RUN = 127;
    private static final int LONGEST_LITERAL = 128;
    private static final int LEAST_RUN = 4;
    /** An exponent of 0 is that of a mantissa in 1/256 of 2⁰. */
    private static final int BIAS = 128;

    private Radiance() {}

    static void write(OutputStream out, Film film) throws IOException {
        int width = film.width();
        out.write(("#?RADIANCE\nSOFTWARE=Lightning\nFORMAT=32-bit_rle_rgbe\n\n-Y " + film.height() + " +X " + width + "\n")
                .getBytes(StandardCharsets.US_ASCII));
        boolean runs = width >= LEAST_WIDTH && width <= MOST_WIDTH;
        byte[] pixels = new byte[4 * width];
        byte[] column = new byte[width];
        for (int y = 0; y < film.height(); y++) {
            for (int x = 0; x < width; x++) {
                encode(film.red(x, y), film.green(x, y), film.blue(x, y), pixels, 4 * x);
            }
            if (!runs) {
                out.write(pixels);
                continue;
            }
            out.write(new byte[] {2, 2, (byte) (width >> 8), (byte) width});
            for (int c = 0; c < 4; c++) {
                for (int x = 0; x < width; x++) {
                    column[x] = pixels[4 * x + c];
                }
                column(out, column);
            }
        }
    }

    /** Writes red, green, blue and exponent of a pixel. */
    static void encode(float red, float green, float blue, byte[] to, int at) {
        double most = Math.max(Math.max(value(red), value(green)), value(blue));
        int exponent = most == 0 ? -BIAS : Math.getExponent(most) + 1;
        // Where the largest mantissa would round to 256, the next exponent serves.
        if (Math.rint(Math.scalb(most, 8 - exponent)) > 255) {
            exponent++;
        }
        boolean black = exponent <= -BIAS;
        to[at] = black ? 0 : mantissa(red, exponent);
        to[at + 1] = black ? 0 : mantissa(green, exponent);
        to[at + 2] = black ? 0 : mantissa(blue, exponent);
        to[at + 3] = (byte) (black ? 0 : exponent + BIAS);
    }

    private static byte mantissa(float v, int exponent) {
        return (byte) Math.rint(Math.scalb(value(v), 8 - exponent));
    }

    /** What can be stored: up to 255/256 of 2¹²⁷. */
    private static double value(float v) {
        return v > 0 ? Math.min(v, Math.scalb(255.0, 127 - 8)) : 0;
    }

    private static void column(OutputStream out, byte[] column) throws IOException {
        for (int x = 0; x < column.length;) {
            int run = run(column, x);
            if (run >= LEAST_RUN) {
                out.write(128 + run);
                out.write(column[x]);
                x += run;
            } else {
                int start = x;
                while (x < column.length && x - start < LONGEST_LITERAL && run(column, x) < LEAST_RUN) {
                    x++;
                }
                out.write(x - start);
                out.write(column, start, x - start);
            }
        }
    }

    private static int run(byte[] column, int from) {
        int end = from + 1;
        while (end < column.length && end - from < LONGEST_RUN && column[end] == column[from]) {
            end++;
        }
        return end - from;
    }
}
