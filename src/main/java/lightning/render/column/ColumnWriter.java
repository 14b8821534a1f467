package lightning.render.column;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.WritableByteChannel;
import java.util.zip.CRC32C;
import org.jspecify.annotations.Nullable;

/**
 * Writer of consecutive columns: numbers, and arrays after their lengths, little-endian. The output ends with a checksum of
 * everything before it.
 */
public final class ColumnWriter {
    /** Length of a missing array. */
    static final int ABSENT = -1;
    private static final int BUFFER_SIZE = 1 << 18;

    private final WritableByteChannel out;
    private final ByteBuffer buffer = ByteBuffer.allocateDirect(BUFFER_SIZE).order(ByteOrder.LITTLE_ENDIAN);
    private final CRC32C checksum = new CRC32C();

    /** @param out channel that accepts all bytes it is given, or throws */
    public ColumnWriter(WritableByteChannel out) {
        this.out = out;
    }

    public void writeInt(int v) throws IOException {
        ensureSpace(Integer.BYTES);
        buffer.putInt(v);
    }

    public void writeLong(long v) throws IOException {
        ensureSpace(Long.BYTES);
        buffer.putLong(v);
    }

    /** Writes an array of a type of {@link ElementType}, of characters or of long integers, or null. */
    public void writeArray(@Nullable Object column) throws IOException {
        switch (column) {
            case null -> writeInt(ABSENT);
            case byte[] a -> {
                writeInt(a.length);
                for (int at = 0, n; at < a.length; at += n) {
                    n = ensureSpace(Byte.BYTES, a.length - at);
                    buffer.put(a, at, n);
                }
            }
            case short[] a -> {
                writeInt(a.length);
                for (int at = 0, n; at < a.length; at += n) {
                    n = ensureSpace(Short.BYTES, a.length - at);
                    buffer.asShortBuffer().put(a, at, n);
                    buffer.position(buffer.position() + n * Short.BYTES);
                }
            }
            case char[] a -> {
                writeInt(a.length);
                for (int at = 0, n; at < a.length; at += n) {
                    n = ensureSpace(Character.BYTES, a.length - at);
                    buffer.asCharBuffer().put(a, at, n);
                    buffer.position(buffer.position() + n * Character.BYTES);
                }
            }
            case long[] a -> {
                writeInt(a.length);
                for (long value : a) {
                    writeLong(value);
                }
            }
            case int[] a -> {
                writeInt(a.length);
                for (int at = 0, n; at < a.length; at += n) {
                    n = ensureSpace(Integer.BYTES, a.length - at);
                    buffer.asIntBuffer().put(a, at, n);
                    buffer.position(buffer.position() + n * Integer.BYTES);
                }
            }
            case float[] a -> {
                writeInt(a.length);
                for (int at = 0, n; at < a.length; at += n) {
                    n = ensureSpace(Float.BYTES, a.length - at);
                    buffer.asFloatBuffer().put(a, at, n);
                    buffer.position(buffer.position() + n * Float.BYTES);
                }
            }
            default -> throw new IllegalArgumentException("unsupported type of a column: " + column.getClass());
        }
    }

    /** Writes several columns of floats, or null. */
    public void writeFloatArrays(float @Nullable [][] columns) throws IOException {
        writeInt(columns == null ? ABSENT : columns.length);
        for (float[] column : columns == null ? new float[0][] : columns) {
            writeArray(column);
        }
    }

    /** Writes all columns of a set, and which of them are missing. */
    public <C extends Enum<C> & ColumnKind> void writeColumns(ColumnSet<C> columns) throws IOException {
        for (C kind : columns.kinds()) {
            writeArray(columns.find(kind));
        }
    }

    /** Writes the checksum; nothing may follow. */
    public void writeChecksum() throws IOException {
        flush();
        buffer.putLong(checksum.getValue());
        buffer.flip();
        writeBuffer();
    }

    private void ensureSpace(int bytes) throws IOException {
        if (buffer.remaining() < bytes) {
            flush();
        }
    }

    /** Makes room for at least one element; returns how many of the remaining ones fit. */
    private int ensureSpace(int elementBytes, int remaining) throws IOException {
        ensureSpace(elementBytes);
        return Math.min(remaining, buffer.remaining() / elementBytes);
    }

    private void flush() throws IOException {
        buffer.flip();
        checksum.update(buffer.duplicate());
        writeBuffer();
    }

    private void writeBuffer() throws IOException {
        while (buffer.hasRemaining()) {
            out.write(buffer);
        }
        buffer.clear();
    }
}
