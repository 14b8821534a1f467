package lightning.format.exr;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.util.BitSet;
import java.util.List;
import java.util.zip.DataFormatException;
import lightning.base.text.Quote;

/**
 * Reader for OpenEXR files of scan lines or tiles, in all compressions but HTJ2K. Of tiles in several sizes, it reads the largest; of
 * several parts, the first one with channels R, G and B. Messages do not repeat the file's name.
 */
public final class ExrReader implements AutoCloseable {
    /** Maximum header size in bytes, with the names of a million shapes. */
    private static final int MAX_HEADER_BYTES = 1 << 26;
    private static final int INITIAL_HEADER_BYTES = 1 << 16;
    /** Maximum uncompressed bytes of a chunk, so that a small damaged file cannot request more. */
    private static final long MAX_CHUNK_BYTES = 1L << 28;

    private final String fileName;
    private final FileChannel file;
    private final ExrPart part;

    /**
     * Opens a file and reads its header.
     *
     * @throws IOException if it is not an OpenEXR file, or of an unsupported kind; the message says which
     */
    public ExrReader(Path path) throws IOException {
        fileName = String.valueOf(path.getFileName());
        file = FileChannel.open(path);
        try {
            part = readHeader(INITIAL_HEADER_BYTES);
            checkSize();
        } catch (IOException | RuntimeException | Error e) {
            file.close();
            throw e;
        }
    }

    private ExrPart readHeader(int length) throws IOException {
        long size = file.size();
        try {
            return new ExrHeaderReader(readBytes(0, (int) Math.min(size, length))).read();
        } catch (EOFException e) {
            if (length >= Math.min(size, MAX_HEADER_BYTES)) {
                throw e;
            }
            return readHeader(MAX_HEADER_BYTES);
        }
    }

    /** Returns the file's name without its folder. */
    String fileName() {
        return fileName;
    }

    /** Returns the header, with the size of the display window. The image size is not validated. */
    public ExrHeader header() {
        return part.shown();
    }

    /** Receives pixel values. */
    public interface PixelConsumer {
        /** Receives the values of a pixel, one for each requested channel, in that order; the array is reused. */
        void accept(int x, int y, float[] values);
    }

    /** Rejects a header that promises more pixels than the file can have, before anyone makes room for them. */
    private void checkSize() throws IOException {
        ExrHeader exrHeader = part.header();
        var whole = new ExrBlock(exrHeader.channels(), exrHeader.width(), 1);
        if (whole.bytesPerLine() > file.size() * exrHeader.compression().maxRatio() / exrHeader.height()) {
            throw truncated();
        }
    }

    /**
     * Reads the pixels.
     *
     * @param names requested channels
     * @param sink receives once every pixel of the display window for which the file has data; the others are black
     * @throws IOException if a channel is missing, or the file is truncated or damaged
     */
    public void read(List<String> names, PixelConsumer sink) throws IOException {
        ExrHeader exrHeader = part.header();
        int[] channels = channelIndices(names);
        int width = part.tileSize() == null ? exrHeader.width() : Math.min(exrHeader.width(), part.tileSize()[0]);
        int height = Math.min(exrHeader.height(), part.tileSize() == null ? part.header().compression().lines() : part.tileSize()[1]);
        long bytes = new ExrBlock(exrHeader.channels(), width, 1).bytesPerLine();
        if (bytes > MAX_CHUNK_BYTES / height) {
            throw new IOException("has chunks of " + bytes + " × " + height + " bytes; expected at most " + MAX_CHUNK_BYTES);
        }
        int columns = Math.ceilDiv(exrHeader.width(), width);
        long chunks = (long) columns * Math.ceilDiv(exrHeader.height(), height);
        if (chunks > file.size() / Long.BYTES) {
            throw truncated();
        }
        ByteBuffer table = readBytes(part.tableOffset(), Math.toIntExact(Long.BYTES * chunks));
        var seen = new BitSet();
        float[] values = new float[channels.length];
        float[][] lines = new float[channels.length][width];
        while (table.hasRemaining()) {
            long offset = table.getLong();
            ByteBuffer start = readBytes(offset, part.chunkHeaderBytes());
            long chunk = chunkIndex(start, height, columns);
            if (chunk < 0 || chunk >= chunks || seen.get((int) chunk)) {
                throw new IOException("has a damaged chunk table: a chunk belongs to no place of the picture or occurs twice");
            }
            seen.set((int) chunk);
            int left = (int) (chunk % columns) * width;
            int top = (int) (chunk / columns) * height;
            var block = new ExrBlock(exrHeader.channels(), Math.min(width, exrHeader.width() - left),
                    Math.min(height, exrHeader.height() - top));
            var pixels = new ExrChunk(block, exrHeader.compression(), readChunk(offset + start.capacity(), start.getInt(), block, top));
            for (int y = 0; y < block.height(); y++) {
                int line = part.header().window().top() + top + y;
                if (line < 0 || line >= part.header().window().height()) {
                    continue;
                }
                for (int i = 0; i < channels.length; i++) {
                    pixels.readLine(channels[i], y, lines[i]);
                }
                for (int x = 0; x < block.width(); x++) {
                    int column = part.header().window().left() + left + x;
                    if (column < 0 || column >= part.header().window().width()) {
                        continue;
                    }
                    for (int i = 0; i < channels.length; i++) {
                        values[i] = lines[i][x];
                    }
                    sink.accept(column, line, values);
                }
            }
        }
    }

    private int[] channelIndices(List<String> names) throws IOException {
        List<String> all = part.header().channels().stream().map(ExrChannel::name).toList();
        for (String name : names) {
            if (!all.contains(name)) {
                throw new IOException("has no channel " + Quote.of(name));
            }
        }
        return names.stream().mapToInt(all::indexOf).toArray();
    }

    /** Returns the index of a chunk, line by line, from its first numbers; −1 if they belong to no chunk of the part's largest size. */
    private long chunkIndex(ByteBuffer start, int height, int columns) {
        if (part.number() >= 0 && start.getInt() != part.number()) {
            return -1;
        }
        if (part.tileSize() == null) {
            long y = (long) start.getInt() - part.top();
            return y % height == 0 ? y / height : -1;
        }
        int column = start.getInt();
        int row = start.getInt();
        boolean isLargest = start.getInt() == 0 & start.getInt() == 0;
        return isLargest && column >= 0 && column < columns && row >= 0 ? (long) row * columns + column : -1;
    }

    private byte[] readChunk(long offset, int size, ExrBlock block, int line) throws IOException {
        if (size < 0 || size > block.byteCount()) {
            throw new IOException("is damaged at line " + line + ": expected at most " + block.byteCount() + " bytes, found " + size);
        }
        byte[] compressed = readBytes(offset, size).array();
        try {
            return part.header().compression().decompress(compressed, block);
        } catch (DataFormatException e) {
            throw new IOException("is damaged at line " + line + ": its chunk does not give " + block.byteCount() + " bytes", e);
        }
    }

    private static EOFException truncated() {
        return new EOFException("is truncated: it has fewer pixels than its header says");
    }

    private ByteBuffer readBytes(long offset, int count) throws IOException {
        if (offset < 0 || offset > file.size() - count) {
            throw truncated();
        }
        ByteBuffer buffer = ByteBuffer.allocate(count).order(ByteOrder.LITTLE_ENDIAN);
        while (buffer.hasRemaining() && file.read(buffer, offset + buffer.position()) >= 0) {
            // Read until the buffer is full.
        }
        if (buffer.hasRemaining()) {
            throw truncated();
        }
        return buffer.flip();
    }

    @Override
    public void close() throws IOException {
        file.close();
    }
}
