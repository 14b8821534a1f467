package lightning.format.image;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;

/**
 * XPM format: an image as C source text, display pixels with 8 bits per channel, lossless. The palette contains every color
 * and is sorted, so that writing is deterministic.
 */
final class Xpm {

    /** 64 characters without escapes in C; four of them encode all 2²⁴ colors. */
    private static final byte[] DIGITS =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+-".getBytes(StandardCharsets.US_ASCII);

    private Xpm() {}

    static void write(OutputStream out, int width, int height, int[] pixels) throws IOException {
        int[] palette = Arrays.stream(pixels).map(pixel -> pixel & 0xFFFFFF).sorted().distinct().toArray();
        int characters = charactersPerPixel(palette.length);
        writeText(out,
                String.format(Locale.ROOT, "/* XPM */\nstatic char *picture[] = {\n\"%d %d %d %d\",\n", width, height, palette.length,
                        characters));
        byte[] name = new byte[characters];
        for (int i = 0; i < palette.length; i++) {
            encodeIndex(i, name, 0, characters);
            writeText(out, "\"" + new String(name, StandardCharsets.US_ASCII) + " c #" + hex(palette[i]) + "\",\n");
        }
        byte[] row = new byte[characters * width];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int color = Arrays.binarySearch(palette, pixels[y * width + x] & 0xFFFFFF);
                encodeIndex(color, row, x * characters, characters);
            }
            out.write('"');
            out.write(row);
            writeText(out, y < height - 1 ? "\",\n" : "\"\n};\n");
        }
    }

    private static int charactersPerPixel(int colorCount) {
        int characters = 1;
        while (1 << 6 * characters < colorCount) {
            characters++;
        }
        return characters;
    }

    private static void encodeIndex(int color, byte[] out, int offset, int characters) {
        for (int i = characters - 1; i >= 0; i--) {
            out[offset + i] = DIGITS[color & 63];
            color >>>= 6;
        }
    }

    private static String hex(int rgb) {
        return Integer.toHexString(0x1000000 | rgb).substring(1);
    }

    private static void writeText(OutputStream out, String text) throws IOException {
        out.write(text.getBytes(StandardCharsets.US_ASCII));
    }
}
