package lightning.format.image;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import lightning.base.file.RegularFile;
import lightning.base.text.Quote;
import lightning.render.image.Film;

/**
 * Portable float map: the linear film, every bit of every float.
 *
 * <p>Three lines of text — {@code PF}, width and height, and a scale whose sign is negative for little-endian — then the
 * interleaved RGB floats, the <em>bottom</em> row first. The scale's magnitude is a brightness unit that no common program
 * applies; it is ignored here too.
 */
final class Pfm {

    /** Maximum token length: a side has at most 5 digits, a scale about 25 characters. */
    private static final int MAX_TOKEN_LENGTH = 32;

    private Pfm() {}

    static void write(OutputStream out, Film film) throws IOException {
        out.write(("PF\n" + film.width() + " " + film.height() + "\n-1.0\n").getBytes(StandardCharsets.US_ASCII));
        ByteBuffer row = ByteBuffer.allocate(12 * film.width()).order(ByteOrder.LITTLE_ENDIAN);
        for (int y = film.height() - 1; y >= 0; y--) {
            row.clear();
            for (int x = 0; x < film.width(); x++) {
                // Copy raw bits: a float register may change the payload of a NaN.
                row.putInt(Float.floatToRawIntBits(film.red(x, y)));
                row.putInt(Float.floatToRawIntBits(film.green(x, y)));
                row.putInt(Float.floatToRawIntBits(film.blue(x, y)));
            }
            out.write(row.array());
        }
    }

    /**
     * Reads an image.
     *
     * @throws IOException if the file is not a color PFM, truncated or too large; the message does not contain its name
     */
    static Film read(Path file) throws IOException {
        try (var in = new DataInputStream(new BufferedInputStream(RegularFile.open(file, "a PFM image"), 1 << 16))) {
            String magic = readToken(in);
            if (!magic.equals("PF")) {
                throw new IOException("is not a color PFM image: expected PF at the start, found " + Quote.of(magic));
            }
            int width = parseSide(readToken(in));
            int height = parseSide(readToken(in));
            ImageLimits.check(width, height);
            ByteOrder order = parseByteOrder(readToken(in));
            if (Files.size(file) < 12L * width * height) {
                throw new EOFException();
            }
            return readPixels(in, width, height, order);
        } catch (EOFException e) {
            throw new IOException("is truncated: it has fewer pixels than its header says", e);
        }
    }

    private static Film readPixels(DataInputStream in, int width, int height, ByteOrder order) throws IOException {
        Film film = Film.black(width, height);
        ByteBuffer row = ByteBuffer.allocate(12 * width).order(order);
        for (int y = height - 1; y >= 0; y--) {
            in.readFully(row.array());
            row.clear();
            for (int x = 0; x < width; x++) {
                int tile = film.tileOf(x, y);
                int pixel = Film.pixelInTile(x, y);
                film.red(tile)[pixel] = Float.intBitsToFloat(row.getInt());
                film.green(tile)[pixel] = Float.intBitsToFloat(row.getInt());
                film.blue(tile)[pixel] = Float.intBitsToFloat(row.getInt());
            }
        }
        return film;
    }

    /** Reads a token and the one white space after it. */
    private static String readToken(DataInputStream in) throws IOException {
        var token = new StringBuilder();
        for (int c = in.readUnsignedByte(); !Character.isWhitespace(c); c = in.readUnsignedByte()) {
            token.append(c > ' ' && c < 127 ? (char) c : '?');
            if (token.length() > MAX_TOKEN_LENGTH) {
                throw new IOException("is not a PFM image: its header has no tokens");
            }
        }
        return token.toString();
    }

    private static int parseSide(String token) throws IOException {
        try {
            return Integer.parseInt(token);
        } catch (NumberFormatException e) {
            throw new IOException("has a damaged PFM header: expected a number of pixels, found " + Quote.of(token), e);
        }
    }

    private static ByteOrder parseByteOrder(String token) throws IOException {
        try {
            double scale = Double.parseDouble(token);
            if (Double.isFinite(scale) && scale != 0) {
                return scale < 0 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
            }
        } catch (NumberFormatException e) {
            // Fall through to the exception below.
        }
        throw new IOException("has a damaged PFM header: expected a scale such as -1.0, found " + Quote.of(token));
    }
}
