package lightning.format.exr;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.util.List;
import java.util.zip.DataFormatException;
import lightning.base.text.Quote;

/**
 * Reads files of one part with lines, not compressed or by ZIP, as most programs write them: what {@link ExrWriter} writes, and more.
 * Messages do not repeat the file's name.
 */
public final class ExrReader implements AutoCloseable {
    /** A header is not longer, with the names of a million shapes in it. */
    private static final int LONGEST_HEADER = 1 << 26;
    private static final int USUAL_HEADER = 1 << 16;
    /** The bytes of a chunk at most, when decompressed: so few of a damaged file can ask for no more. */
    private static final long MOST_OF_CHUNK = 1L << 28;

    private final FileChannel file;
    private final HeaderReader.Read header;

    /**
     * Reads the header.
     *
     * @throws IOException if it is no such file, or one of another kind; the message says which
     */
    public ExrReader(Path path) throws IOException {
        file = FileChannel.open(path);
        try {
            header = header(USUAL_HEADER);
        } catch (IOException | RuntimeException | Error e) {
            file.close();
            throw e;
        }
    }

    private HeaderReader.Read header(int length) throws IOException {
        long size = file.size();
        try {
            return new HeaderReader(bytes(0, (int) Math.min(size, length))).read();
        } catch (EOFException e) {
            if (length >= Math.min(size, LONGEST_HEADER)) {
                throw e;
            }
            return header(LONGEST_HEADER);
        }
    }

    /** What the file says of itself. The picture's size is not checked. */
    public ExrHeader header() {
        return header.header();
    }

    /** Gets the numbers of pixels. */
    public interface Sink {
        /** The numbers of a pixel, one for each channel that was asked for, in that order; the array is used again. */
        void pixel(int x, int y, float[] values);
    }

    /**
     * Reads the numbers.
     *
     * @param names of the channels wanted
     * @param to    gets every pixel once
     * @throws IOException if a channel is not there, or the file is cut short or damaged
     */
    public void read(List<String> names, Sink to) throws IOException {
        ExrHeader picture = header.header();
        int compression = header.compression();
        int[] wanted = new int[names.size()];
        List<String> there = picture.channels().stream().map(ExrChannel::name).toList();
        for (int i = 0; i < wanted.length; i++) {
            wanted[i] = there.indexOf(names.get(i));
            if (wanted[i] < 0) {
                throw new IOException("has no channel " + Quote.of(names.get(i)));
            }
        }
        int lines = compression == 3 ? ExrHeader.LINES : 1;
        int chunks = Math.ceilDiv(picture.height(), lines);
        long bytes = picture.bytesPerLine() * lines;
        if (bytes > MOST_OF_CHUNK) {
            throw new IOException("has lines of " + picture.bytesPerLine() + " bytes; expected at most " + MOST_OF_CHUNK / lines);
        }
        ByteBuffer table = bytes(header.end(), Math.multiplyExact(Long.BYTES, chunks));
        boolean[] read = new boolean[picture.height()];
        int[] starts = picture.starts();
        float[] values = new float[wanted.length];
        for (int c = 0; c < chunks; c++) {
            long at = table.getLong();
            ByteBuffer head = bytes(at, 2 * Integer.BYTES);
            long y = (long) head.getInt() - header.top();
            int size = head.getInt();
            if (y < 0 || y >= picture.height() || y % lines != 0 || read[(int) y]) {
                throw new IOException("has a damaged table of chunks: one begins at line " + y);
            }
            read[(int) y] = true;
            int count = (int) Math.min(lines, picture.height() - y);
            ExrChunk chunk =
                    new ExrChunk(picture, starts, unpacked(at + 2 * Integer.BYTES, size, (int) (picture.bytesPerLine() * count), y));
            for (int dy = 0; dy < count; dy++) {
                for (int x = 0; x < picture.width(); x++) {
                    for (int i = 0; i < wanted.length; i++) {
                        values[i] = chunk.get(wanted[i], x, dy);
                    }
                    to.pixel(x, (int) y + dy, values);
                }
            }
        }
    }

    private byte[] unpacked(long at, int size, int length, long y) throws IOException {
        if (size < 0 || size > length) {
            throw new IOException("is damaged at line " + y + ": expected at most " + length + " bytes, found " + size);
        }
        byte[] packed = bytes(at, size).array();
        try {
            return header.compression() == 0 && size != length ? fail() : ExrChunk.unpacked(packed, length);
        } catch (DataFormatException e) {
            throw new IOException("is damaged at line " + y + ": its chunk does not give " + length + " bytes", e);
        }
    }

    private static byte[] fail() throws DataFormatException {
        throw new DataFormatException();
    }

    private ByteBuffer bytes(long at, int count) throws IOException {
        if (at < 0 || at > file.size() - count) {
            throw new EOFException("is cut short: it has fewer pixels than its header says");
        }
        ByteBuffer buffer = ByteBuffer.allocate(count).order(ByteOrder.LITTLE_ENDIAN);
        while (buffer.hasRemaining() && file.read(buffer, at + buffer.position()) >= 0) {
            // Until all is there.
        }
        if (buffer.hasRemaining()) {
            throw new EOFException("is cut short: it has fewer pixels than its header says");
        }
        return buffer.flip();
    }

    @Override
    public void close() throws IOException {
        file.close();
    }
}
