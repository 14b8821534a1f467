package lightning.format.mesh;

import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import lightning.base.file.RegularFile;
import lightning.base.work.Progress;

/**
 * Buffered sequential reader of a file with known size. Declared sizes can be checked against the remaining bytes before
 * memory is allocated.
 */
public final class ByteSource implements AutoCloseable {
    private static final int BLOCK_BYTES = 1 << 16;
    private static final byte[] UTF_16 = {(byte) 0xFE, (byte) 0xFF};
    private static final byte[] UTF_16_SWAPPED = {(byte) 0xFF, (byte) 0xFE};
    private static final int MAX_UTF_16_BYTES = 1 << 28;

    private final Path file;
    private final InputStream in;
    private final Progress progress;
    private final long size;
    private final byte[] block = new byte[BLOCK_BYTES];
    private final ByteBuffer buffer = ByteBuffer.wrap(block).order(ByteOrder.LITTLE_ENDIAN);
    /** File offset of the current block. */
    private long blockOffset;
    private int position;
    private int limit;

    private ByteSource(Path file, InputStream in, long size, Progress progress) {
        this.file = file;
        this.in = in;
        this.size = size;
        this.progress = progress;
    }

    /**
     * Opens a file of at most {@link MeshLimits#FILE_BYTES}.
     *
     * @param progress receives the number of KiB read
     * @throws IOException if it cannot be read, or is a folder, a pipe or a device; these are not opened
     * @throws MeshException if it is larger
     */
    public static ByteSource open(Path file, Progress progress) throws IOException, MeshException {
        InputStream in = RegularFile.open(file, "a file of meshes");
        long size = Files.size(file);
        if (size > MeshLimits.FILE_BYTES) {
            in.close();
            throw new MeshException(file, "", "must have at most " + MeshLimits.FILE_BYTES + " bytes, has " + size);
        }
        return new ByteSource(file, in, size, progress);
    }

    /** Opens a file as {@link #open}; text in UTF-16, which a byte order mark says, is read as UTF-8. */
    public static ByteSource openText(Path file, Progress progress) throws IOException, MeshException {
        ByteSource source = open(file, progress);
        if (source.startsWith(UTF_16) || source.startsWith(UTF_16_SWAPPED)) {
            try (source) {
                return ofUtf16(source);
            }
        }
        return source;
    }

    private static ByteSource ofUtf16(ByteSource source) throws IOException, MeshException {
        if (source.remaining() > MAX_UTF_16_BYTES) {
            throw source.problem("", "must have at most " + MAX_UTF_16_BYTES + " bytes as text in UTF-16, has " + source.remaining());
        }
        byte[] text = source.bytes((int) source.remaining());
        // The mark says which byte comes first, and is no part of the text.
        byte[] bytes = new String(text, StandardCharsets.UTF_16).getBytes(StandardCharsets.UTF_8);
        return new ByteSource(source.file, new ByteArrayInputStream(bytes), bytes.length, source.progress);
    }

    public Path file() {
        return file;
    }

    /** Creates a problem with this file. */
    public MeshException problem(String location, String message) {
        return new MeshException(file, location, message);
    }

    /** Returns the number of bytes read. */
    public long offset() {
        return blockOffset + position;
    }

    /** Returns the number of remaining bytes, by the file's size when it was opened. */
    public long remaining() {
        return size - blockOffset - position;
    }

    /** Returns the next byte, 0 to 255, without consuming it; −1 at the end. */
    public int peek() throws IOException {
        return position < limit || fill(1) ? block[position] & 0xFF : -1;
    }

    /** Returns the next byte, 0 to 255; −1 at the end. */
    public int next() throws IOException {
        return position < limit || fill(1) ? block[position++] & 0xFF : -1;
    }

    /** Returns whether the next bytes equal the given ones; does not consume them. */
    public boolean startsWith(byte[] bytes) throws IOException {
        if (!fill(bytes.length)) {
            return false;
        }
        for (int i = 0; i < bytes.length; i++) {
            if (block[position + i] != bytes[i]) {
                return false;
            }
        }
        return true;
    }

    /** Sets the byte order of numbers; little-endian by default. */
    public void setByteOrder(ByteOrder order) {
        buffer.order(order);
    }

    /**
     * Reads a signed byte.
     *
     * @throws EOFException if the file ends, as in all methods that read numbers
     */
    public byte int8() throws IOException {
        return block[consume(1)];
    }

    public short int16() throws IOException {
        return buffer.getShort(consume(2));
    }

    public int int32() throws IOException {
        return buffer.getInt(consume(4));
    }

    public float float32() throws IOException {
        return buffer.getFloat(consume(4));
    }

    public double float64() throws IOException {
        return buffer.getDouble(consume(8));
    }

    /** Reads an array of bytes; allocates it only if the file has enough bytes. */
    public byte[] bytes(int count) throws IOException {
        if (count > remaining()) {
            throw new EOFException();
        }
        byte[] result = new byte[count];
        for (int copied = 0; copied < count;) {
            int part = Math.min(count - copied, BLOCK_BYTES);
            System.arraycopy(block, consume(part), result, copied, part);
            copied += part;
        }
        return result;
    }

    private int consume(int bytes) throws IOException {
        if (limit - position < bytes && !fill(bytes)) {
            throw new EOFException();
        }
        position += bytes;
        return position - bytes;
    }

    /**
     * Fills the block with at least the given number of bytes, at most a block; returns false if the file is too short.
     * Bytes appended to the file since it was opened are not read.
     */
    private boolean fill(int bytes) throws IOException {
        if (limit - position >= bytes) {
            return true;
        }
        progress.checkCanceled("canceled after " + offset() + " of " + size + " bytes");
        System.arraycopy(block, position, block, 0, limit - position);
        blockOffset += position;
        limit -= position;
        position = 0;
        int count = in.readNBytes(block, limit, (int) Math.min(BLOCK_BYTES - limit, size - blockOffset - limit));
        limit += count;
        progress.report((int) ((blockOffset + limit) >> 10), (int) (size >> 10));
        return limit >= bytes;
    }

    @Override
    public void close() throws IOException {
        in.close();
    }
}
