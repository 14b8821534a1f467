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
 * Reader for single-part scan-line OpenEXR files, uncompressed or ZIP: the output of {@link ExrWriter} and of most programs.
 * Messages do not repeat the file's name.
 */
public final class ExrReader implements AutoCloseable {
    /** Maximum header size in bytes, with the names of a million shapes. */
    private static final int MAX_HEADER_BYTES = 1 << 26;
    private static final int INITIAL_HEADER_BYTES = 1 << 16;
    /** Maximum uncompressed bytes of a chunk, so that a small damaged file cannot request more. */
    private static final long MAX_CHUNK_BYTES = 1L << 28;

    private final FileChannel file;
    private final ExrHeaderReader.Result header;

    /**
     * Opens a file and reads its header.
     *
     * @throws IOException if it is not an OpenEXR file, or of an unsupported kind; the message says which
     */
    public ExrReader(Path path) throws IOException {
        file = FileChannel.open(path);
        try {
            header = readHeader(INITIAL_HEADER_BYTES);
        } catch (IOException | RuntimeException | Error e) {
            file.close();
            throw e;
        }
    }

    private ExrHeaderReader.Result readHeader(int length) throws IOException {
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

    /** Returns the header. The image size is not validated. */
    public ExrHeader header() {
        return header.header();
    }

    /** Receives pixel values. */
    public interface PixelConsumer {
        /** Receives the values of a pixel, one for each requested channel, in that order; the array is reused. */
        void accept(int x, int y, float[] values);
    }

    /**
     * Reads the pixels.
     *
     * @param names requested channels
     * @param sink receives every pixel once
     * @throws IOException if a channel is missing, or the file is truncated or damaged
     */
    public void read(List<String> names, PixelConsumer sink) throws IOException {
        ExrHeader exrHeader = header.header();
        int compression = header.compression();
        int[] channelIndices = new int[names.size()];
        List<String> channelNames = exrHeader.channels().stream().map(ExrChannel::name).toList();
        for (int i = 0; i < channelIndices.length; i++) {
            channelIndices[i] = channelNames.indexOf(names.get(i));
            if (channelIndices[i] < 0) {
                throw new IOException("has no channel " + Quote.of(names.get(i)));
            }
        }
        int lines = compression == 3 ? ExrHeader.LINES_PER_CHUNK : 1;
        int chunks = Math.ceilDiv(exrHeader.height(), lines);
        long bytes = exrHeader.bytesPerLine() * lines;
        if (bytes > MAX_CHUNK_BYTES) {
            throw new IOException("has lines of " + exrHeader.bytesPerLine() + " bytes; expected at most " + MAX_CHUNK_BYTES / lines);
        }
        ByteBuffer table = readBytes(header.headerBytes(), Math.multiplyExact(Long.BYTES, chunks));
        boolean[] seenLines = new boolean[exrHeader.height()];
        int[] channelOffsets = exrHeader.channelOffsets();
        float[] values = new float[channelIndices.length];
        for (int c = 0; c < chunks; c++) {
            long offset = table.getLong();
            ByteBuffer chunkHeader = readBytes(offset, 2 * Integer.BYTES);
            long y = (long) chunkHeader.getInt() - header.top();
            int size = chunkHeader.getInt();
            if (y < 0 || y >= exrHeader.height() || y % lines != 0 || seenLines[(int) y]) {
                throw new IOException("has a damaged chunk table: a chunk begins at line " + y);
            }
            seenLines[(int) y] = true;
            int count = (int) Math.min(lines, exrHeader.height() - y);
            ExrChunk chunk =
                    new ExrChunk(exrHeader, channelOffsets,
                            readChunk(offset + 2 * Integer.BYTES, size, (int) (exrHeader.bytesPerLine() * count), y));
            for (int dy = 0; dy < count; dy++) {
                for (int x = 0; x < exrHeader.width(); x++) {
                    for (int i = 0; i < channelIndices.length; i++) {
                        values[i] = chunk.get(channelIndices[i], x, dy);
                    }
                    sink.accept(x, (int) y + dy, values);
                }
            }
        }
    }

    private byte[] readChunk(long offset, int size, int length, long y) throws IOException {
        if (size < 0 || size > length) {
            throw new IOException("is damaged at line " + y + ": expected at most " + length + " bytes, found " + size);
        }
        byte[] compressed = readBytes(offset, size).array();
        try {
            return header.compression() == 0 && size != length ? throwFormatException() : ExrChunk.decompress(compressed, length);
        } catch (DataFormatException e) {
            throw new IOException("is damaged at line " + y + ": its chunk does not give " + length + " bytes", e);
        }
    }

    private static byte[] throwFormatException() throws DataFormatException {
        throw new DataFormatException();
    }

    private ByteBuffer readBytes(long offset, int count) throws IOException {
        if (offset < 0 || offset > file.size() - count) {
            throw new EOFException("is truncated: it has fewer pixels than its header says");
        }
        ByteBuffer buffer = ByteBuffer.allocate(count).order(ByteOrder.LITTLE_ENDIAN);
        while (buffer.hasRemaining() && file.read(buffer, offset + buffer.position()) >= 0) {
            // Read until the buffer is full.
        }
        if (buffer.hasRemaining()) {
            throw new EOFException("is truncated: it has fewer pixels than its header says");
        }
        return buffer.flip();
    }

    @Override
    public void close() throws IOException {
        file.close();
    }
}
