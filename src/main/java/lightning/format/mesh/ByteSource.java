package lightning.format.mesh;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import lightning.base.file.OrdinaryFile;
import lightning.base.work.Progress;

/**
 * The bytes of a file from its first to its last, through a small buffer. It knows how many there are, so that what a file says
 * to hold can be held against them before memory is taken for it.
 */
public final class ByteSource implements AutoCloseable {
    private static final int BLOCK = 1 << 16;

    private final Path file;
    private final InputStream in;
    private final Progress progress;
    private final long size;
    private final byte[] block = new byte[BLOCK];
    private final ByteBuffer numbers = ByteBuffer.wrap(block).order(ByteOrder.LITTLE_ENDIAN);
    /** How many bytes of the file stand before those in the block. */
    private long before;
    private int at;
    private int end;

    private ByteSource(Path file, InputStream in, long size, Progress progress) {
        this.file = file;
        this.in = in;
        this.size = size;
        this.progress = progress;
    }

    /**
     * Opens a file of at most {@link MeshLimits#FILE_BYTES}.
     *
     * @param progress hears how many KiB of the file are read
     * @throws IOException   if it cannot be read, or is a folder, a pipe or a device, which are not opened
     * @throws MeshException if it is larger
     */
    public static ByteSource open(Path file, Progress progress) throws IOException, MeshException {
        InputStream in = OrdinaryFile.open(file, "a file of meshes");
        long size = Files.size(file);
        if (size > MeshLimits.FILE_BYTES) {
            in.close();
            throw new MeshException(file, "", "must have at most " + MeshLimits.FILE_BYTES + " bytes, has " + size);
        }
        return new ByteSource(file, in, size, progress);
    }

    public Path file() {
        return file;
    }

    /** A problem with this file. */
    public MeshException problem(String place, String message) {
        return new MeshException(file, place, message);
    }

    /** How many bytes were read. */
    public long offset() {
        return before + at;
    }

    /** How many bytes there are still, by the size that the file had when it was opened. */
    public long left() {
        return size - before - at;
    }

    /** The next byte, 0 to 255, which stays the next; −1 at the end. */
    public int peek() throws IOException {
        return at < end || fill(1) ? block[at] & 0xFF : -1;
    }

    /** The next byte, 0 to 255; −1 at the end. */
    public int next() throws IOException {
        return at < end || fill(1) ? block[at++] & 0xFF : -1;
    }

    /** Whether the next bytes are these; they stay the next. */
    public boolean startsWith(byte[] bytes) throws IOException {
        if (!fill(bytes.length)) {
            return false;
        }
        for (int i = 0; i < bytes.length; i++) {
            if (block[at + i] != bytes[i]) {
                return false;
            }
        }
        return true;
    }

    /** In which order the bytes of numbers stand; the smallest first, unless this says otherwise. */
    public void order(ByteOrder order) {
        numbers.order(order);
    }

    /** @throws EOFException if the file ends before it, as from all that read numbers */
    public byte int8() throws IOException {
        return block[take(1)];
    }

    public short int16() throws IOException {
        return numbers.getShort(take(2));
    }

    public int int32() throws IOException {
        return numbers.getInt(take(4));
    }

    public float float32() throws IOException {
        return numbers.getFloat(take(4));
    }

    public double float64() throws IOException {
        return numbers.getDouble(take(8));
    }

    /** So many bytes; taken only where the file has them. */
    public byte[] bytes(int count) throws IOException {
        if (count > left()) {
            throw new EOFException();
        }
        byte[] all = new byte[count];
        for (int done = 0; done < count;) {
            int part = Math.min(count - done, BLOCK);
            System.arraycopy(block, take(part), all, done, part);
            done += part;
        }
        return all;
    }

    private int take(int bytes) throws IOException {
        if (end - at < bytes && !fill(bytes)) {
            throw new EOFException();
        }
        at += bytes;
        return at - bytes;
    }

    /** Whether so many bytes, at most a block, stand in the block now. What the file got since it was opened is not read. */
    private boolean fill(int bytes) throws IOException {
        if (end - at >= bytes) {
            return true;
        }
        if (progress.isCancelled()) {
            throw new CancellationException("cancelled after " + offset() + " of " + size + " bytes");
        }
        System.arraycopy(block, at, block, 0, end - at);
        before += at;
        end -= at;
        at = 0;
        int more = in.readNBytes(block, end, (int) Math.min(BLOCK - end, size - before - end));
        end += more;
        progress.tiles((int) ((before + end) >> 10), (int) (size >> 10));
        return end >= bytes;
    }

    @Override
    public void close() throws IOException {
        in.close();
    }
}
