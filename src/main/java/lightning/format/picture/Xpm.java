package lightning.format.picture;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.base.file.OrdinaryFile;
import lightning.render.image.Film;
import lightning.render.image.Pixels;
import org.apache.commons.imaging.bytesource.ByteSource;
import org.apache.commons.imaging.formats.xpm.XpmImageParser;

/**
 * XPM, the picture as C source text: display pixels, 8 bits a channel, without loss.
 *
 * <p>Reading is left to Commons Imaging. Writing is not: its writer looks up each pixel by walking the palette, which
 * takes minutes for a shaded picture of tens of thousands of colours, and it names the picture at random, so that
 * saving twice gives two different files. Here every colour stays what it is and the palette is sorted.
 */
final class Xpm {

    /** 64 characters that need no escape in C; four of them name all 2²⁴ colours. */
    private static final byte[] DIGITS =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+-".getBytes(StandardCharsets.US_ASCII);

    private static final String SPACE_OR_COMMENT = "(?:\\s|/\\*[^*]{0,200}+\\*/)*+";

    /** Everything up to the first string: width, height, number of colours, characters per pixel. */
    private static final Pattern HEADER = Pattern.compile("/\\*\\s*XPM\\s*\\*/" + SPACE_OR_COMMENT
            + "static\\s+char\\s*\\*\\s*\\w+\\s*\\[\\s*\\]\\s*=\\s*\\{" + SPACE_OR_COMMENT
            + "\"\\s*+(\\d{1,9})\\s+(\\d{1,9})\\s+(\\d{1,9})\\s+(\\d{1,2})[\\s\"]");

    private static final int LONGEST_HEADER = 2048;

    private Xpm() {}

    static void write(OutputStream out, int width, int height, int[] pixels) throws IOException {
        int[] palette = Arrays.stream(pixels).map(pixel -> pixel & 0xFFFFFF).sorted().distinct().toArray();
        int characters = charactersFor(palette.length);
        text(out, String.format(Locale.ROOT, "/* XPM */\nstatic char *picture[] = {\n\"%d %d %d %d\",\n", width, height, palette.length,
                characters));
        byte[] name = new byte[characters];
        for (int i = 0; i < palette.length; i++) {
            name(i, name, 0, characters);
            text(out, "\"" + new String(name, StandardCharsets.US_ASCII) + " c #" + hex(palette[i]) + "\",\n");
        }
        byte[] row = new byte[characters * width];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int colour = Arrays.binarySearch(palette, pixels[y * width + x] & 0xFFFFFF);
                name(colour, row, x * characters, characters);
            }
            out.write('"');
            out.write(row);
            text(out, y < height - 1 ? "\",\n" : "\"\n};\n");
        }
    }

    /** @throws IOException if the file is no XPM that Commons Imaging can read, or is too large; without its name */
    static Film read(Path file) throws IOException {
        checkHeader(file);
        try {
            return Pixels.toFilm(new XpmImageParser().getBufferedImage(ByteSource.file(file.toFile()), null));
        } catch (RuntimeException e) {
            // The parser answers some damaged files with unchecked exceptions.
            throw new IOException("is no undamaged XPM picture", e);
        }
    }

    private static void checkHeader(Path file) throws IOException {
        String start;
        try (var in = OrdinaryFile.open(file, "a XPM picture")) {
            start = new String(in.readNBytes(LONGEST_HEADER), StandardCharsets.ISO_8859_1);
        }
        Matcher header = HEADER.matcher(start);
        if (!header.lookingAt()) {
            throw new IOException("is no XPM picture: expected /* XPM */, static char * and four numbers");
        }
        long width = Long.parseLong(header.group(1));
        long height = Long.parseLong(header.group(2));
        PictureLimits.check(width, height);
        long text = (width * height + Long.parseLong(header.group(3))) * Long.parseLong(header.group(4));
        if (text > Files.size(file)) {
            throw new IOException("is cut short: it has fewer pixels or colours than its header says");
        }
    }

    private static int charactersFor(int colours) {
        int characters = 1;
        while (1 << 6 * characters < colours) {
            characters++;
        }
        return characters;
    }

    private static void name(int colour, byte[] to, int at, int characters) {
        for (int i = characters - 1; i >= 0; i--) {
            to[at + i] = DIGITS[colour & 63];
            colour >>>= 6;
        }
    }

    private static String hex(int rgb) {
        return Integer.toHexString(0x1000000 | rgb).substring(1);
    }

    private static void text(OutputStream out, String text) throws IOException {
        out.write(text.getBytes(StandardCharsets.US_ASCII));
    }
}
