package lightning.format.image;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import lightning.render.image.Film;

/**
 * Radiance {@code .hdr} format: three 8-bit mantissas per pixel with a shared exponent (Ward, Real Pixels, Graphics Gems II,
 * 1991), rounded to nearest, with run-length encoding of the four columns of a line. Negative values and NaN become 0.
 */
final class RadianceHdr {
    /** Minimum width for run-length encoding. */
    private static final int MIN_RLE_WIDTH = 8;
    private static final int MAX_RLE_WIDTH = 0x7FFF;
    private static final int MAX_RUN = 127;
    private static final int MAX_LITERAL = 128;
    private static final int MIN_RUN = 4;
    /** Exponent bias: a stored exponent of 0 scales mantissas by 1/256. */
    private static final int BIAS = 128;

    private RadianceHdr() {}

    static void write(OutputStream out, Film film) throws IOException {
        int width = film.width();
        out.write(("#?RADIANCE\nSOFTWARE=Lightning\nFORMAT=32-bit_rle_rgbe\n\n-Y " + film.height() + " +X " + width + "\n")
                .getBytes(StandardCharsets.US_ASCII));
        boolean isRunLength = width >= MIN_RLE_WIDTH && width <= MAX_RLE_WIDTH;
        byte[] pixels = new byte[4 * width];
        byte[] channel = new byte[width];
        for (int y = 0; y < film.height(); y++) {
            for (int x = 0; x < width; x++) {
                encode(film.red(x, y), film.green(x, y), film.blue(x, y), pixels, 4 * x);
            }
            if (!isRunLength) {
                out.write(pixels);
                continue;
            }
            out.write(new byte[] {2, 2, (byte) (width >> 8), (byte) width});
            for (int c = 0; c < 4; c++) {
                for (int x = 0; x < width; x++) {
                    channel[x] = pixels[4 * x + c];
                }
                writeChannel(out, channel);
            }
        }
    }

    /** Encodes red, green, blue and exponent of a pixel. */
    static void encode(float red, float green, float blue, byte[] out, int offset) {
        double max = Math.max(Math.max(clampToRange(red), clampToRange(green)), clampToRange(blue));
        int exponent = max == 0 ? -BIAS : Math.getExponent(max) + 1;
        // If the largest mantissa would round to 256, use the next exponent.
        if (Math.rint(Math.scalb(max, 8 - exponent)) > 255) {
            exponent++;
        }
        boolean isBlack = exponent <= -BIAS;
        out[offset] = isBlack ? 0 : mantissa(red, exponent);
        out[offset + 1] = isBlack ? 0 : mantissa(green, exponent);
        out[offset + 2] = isBlack ? 0 : mantissa(blue, exponent);
        out[offset + 3] = (byte) (isBlack ? 0 : exponent + BIAS);
    }

    private static byte mantissa(float v, int exponent) {
        return (byte) Math.rint(Math.scalb(clampToRange(v), 8 - exponent));
    }

    /** Clamps to the storable range, up to 255/256 of 2¹²⁷. */
    private static double clampToRange(float v) {
        return v > 0 ? Math.min(v, Math.scalb(255.0, 127 - 8)) : 0;
    }

    private static void writeChannel(OutputStream out, byte[] channel) throws IOException {
        for (int x = 0; x < channel.length;) {
            int run = runLength(channel, x);
            if (run >= MIN_RUN) {
                out.write(128 + run);
                out.write(channel[x]);
                x += run;
            } else {
                int start = x;
                while (x < channel.length && x - start < MAX_LITERAL && runLength(channel, x) < MIN_RUN) {
                    x++;
                }
                out.write(x - start);
                out.write(channel, start, x - start);
            }
        }
    }

    private static int runLength(byte[] channel, int start) {
        int end = start + 1;
        while (end < channel.length && end - start < MAX_RUN && channel[end] == channel[start]) {
            end++;
        }
        return end - start;
    }
}
