package lightning.format.image;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import lightning.base.file.RegularFile;
import lightning.base.text.Quote;
import lightning.scene.asset.TextureUsage;

/** Portable float map that {@link Pfm} describes; the bottom row is first. */
final class PfmImage extends ImageSource {
    /** Maximum token length: a side has at most 5 digits, a scale about 25 characters. */
    private static final int MAX_TOKEN_LENGTH = 32;
    private static final int MAX_HEADER_BYTES = 4 * (MAX_TOKEN_LENGTH + 1);
    private static final int PIXEL_BYTES = 3 * Float.BYTES;

    private final Path file;
    private final byte[] start;
    private final int width;
    private final int height;
    private final ByteOrder order;
    /** Bytes of the header. */
    private int next;

    /** Reads the header of a file. */
    PfmImage(Path file) throws IOException {
        this.file = file;
        try (InputStream in = RegularFile.open(file, "a PFM image")) {
            start = in.readNBytes(MAX_HEADER_BYTES);
        }
        String magic = readToken();
        if (!magic.equals("PF")) {
            throw new IOException("is not a color PFM image: expected PF at the start, found " + Quote.of(magic));
        }
        width = parseSide(readToken());
        height = parseSide(readToken());
        order = parseByteOrder(readToken());
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
        if (Files.size(file) - next < PIXEL_BYTES * pixelCount()) {
            throw truncated();
        }
    }

    @Override
    Pixels pixels(TextureUsage usage) {
        return sink -> {
            try (var in = new BufferedInputStream(RegularFile.open(file, "a PFM image"), 1 << 16)) {
                in.skipNBytes(next);
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
            }
        };
    }

    /** Reads a token and the one white space after it. */
    private String readToken() throws IOException {
        int from = next;
        while (next < start.length && !Character.isWhitespace(start[next])) {
            next++;
        }
        if (next - from > MAX_TOKEN_LENGTH) {
            throw new IOException("is not a PFM image: its header has no tokens");
        }
        if (next == start.length) {
            throw truncated();
        }
        return new String(start, from, next++ - from, StandardCharsets.ISO_8859_1);
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
