package lightning.format.image;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import lightning.base.text.Quote;
import lightning.scene.asset.TextureUsage;

/** Portable float map that {@link Pfm} describes; the bottom row is first. */
final class PfmImage extends ImageSource {
    /** Maximum token length: a side has at most 5 digits, a scale about 25 characters. */
    private static final int MAX_TOKEN_LENGTH = 32;
    private static final int PIXEL_BYTES = 3 * Float.BYTES;

    private final Path file;
    private final DataInputStream in;
    private final int width;
    private final int height;
    private final ByteOrder order;

    /** Reads the header of a file. */
    PfmImage(Path file) throws IOException {
        this.file = file;
        in = new DataInputStream(new BufferedInputStream(Files.newInputStream(file), 1 << 16));
        try {
            String magic = readToken(in);
            if (!magic.equals("PF")) {
                throw new IOException("is not a color PFM image: expected PF at the start, found " + Quote.of(magic));
            }
            width = parseSide(readToken(in));
            height = parseSide(readToken(in));
            order = parseByteOrder(readToken(in));
        } catch (EOFException e) {
            in.close();
            throw truncated();
        } catch (IOException e) {
            in.close();
            throw e;
        }
    }

    private static IOException truncated() {
        return new IOException("is truncated: it has fewer pixels than its header says");
    }

    @Override
    public int width() {
        return width;
    }

    @Override
    public int height() {
        return height;
    }

    @Override
    public boolean hasFullFloats() {
        return true;
    }

    @Override
    void check() throws IOException {
        if (Files.size(file) < PIXEL_BYTES * pixelCount()) {
            throw truncated();
        }
    }

    /** Returns the pixels, which can be delivered once. */
    @Override
    Pixels pixels(TextureUsage usage) {
        return sink -> {
            ByteBuffer row = ByteBuffer.allocate(PIXEL_BYTES * width).order(order);
            FloatBuffer floats = row.asFloatBuffer();
            float[] rgb = new float[3];
            for (int y = height - 1; y >= 0; y--) {
                if (in.readNBytes(row.array(), 0, row.capacity()) < row.capacity()) {
                    throw truncated();
                }
                for (int x = 0; x < width; x++) {
                    floats.get(3 * x, rgb);
                    sink.accept(x, y, rgb);
                }
            }
        };
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

    @Override
    public void close() throws IOException {
        in.close();
    }
}
