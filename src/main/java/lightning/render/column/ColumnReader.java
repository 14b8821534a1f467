package lightning.render.column;

import java.io.EOFException;
import java.io.IOException;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import java.nio.ByteOrder;
import java.util.zip.CRC32C;
import org.jspecify.annotations.Nullable;

/** Reader for the output of a {@link ColumnWriter}. Verifies the checksum first, so that damaged data is never read. */
public final class ColumnReader {
    private static final ValueLayout.OfShort SHORT = ValueLayout.JAVA_SHORT_UNALIGNED.withOrder(ByteOrder.LITTLE_ENDIAN);
    private static final ValueLayout.OfChar CHAR = ValueLayout.JAVA_CHAR_UNALIGNED.withOrder(ByteOrder.LITTLE_ENDIAN);
    private static final ValueLayout.OfInt INT = ValueLayout.JAVA_INT_UNALIGNED.withOrder(ByteOrder.LITTLE_ENDIAN);
    private static final ValueLayout.OfFloat FLOAT = ValueLayout.JAVA_FLOAT_UNALIGNED.withOrder(ByteOrder.LITTLE_ENDIAN);
    private static final ValueLayout.OfLong LONG = ValueLayout.JAVA_LONG_UNALIGNED.withOrder(ByteOrder.LITTLE_ENDIAN);
    /** Bytes per update of the checksum. */
    private static final long CHECKSUM_CHUNK = 1 << 26;

    private final MemorySegment in;
    /** Start of the checksum. */
    private final long end;
    private long position;

    /**
     * @param in complete output of a writer
     * @throws IOException if it is damaged
     */
    public ColumnReader(MemorySegment in) throws IOException {
        this.in = in;
        end = in.byteSize() - Long.BYTES;
        if (end < 0 || checksum() != in.get(LONG, end)) {
            throw new IOException("checksum mismatch: the data is damaged");
        }
    }

    private long checksum() {
        CRC32C sum = new CRC32C();
        for (long from = 0; from < end; from += CHECKSUM_CHUNK) {
            sum.update(in.asSlice(from, Math.min(CHECKSUM_CHUNK, end - from)).asByteBuffer());
        }
        return sum.getValue();
    }

    public int readInt() throws IOException {
        return in.get(INT, advance(Integer.BYTES));
    }

    public long readLong() throws IOException {
        return in.get(LONG, advance(Long.BYTES));
    }

    /** Reads the number of elements of at least one byte each. */
    public int readCount() throws IOException {
        int count = readInt();
        if (count < 0 || count > end - position) {
            throw new IOException("expected a count from 0 to " + (end - position) + ", found " + count);
        }
        return count;
    }

    /** Reads an array of elements of a type, or null. */
    public @Nullable Object readArray(ElementType element) throws IOException {
        int length = readInt();
        if (length == ColumnWriter.ABSENT) {
            return null;
        }
        if (length < 0) {
            throw new IOException("expected an array length of at least 0, found " + length);
        }
        long from = advance((long) length * element.bytes());
        return switch (element) {
            case BYTE -> {
                byte[] a = new byte[length];
                MemorySegment.copy(in, ValueLayout.JAVA_BYTE, from, a, 0, length);
                yield a;
            }
            case SHORT -> {
                short[] a = new short[length];
                MemorySegment.copy(in, SHORT, from, a, 0, length);
                yield a;
            }
            case INT -> {
                int[] a = new int[length];
                MemorySegment.copy(in, INT, from, a, 0, length);
                yield a;
            }
            case FLOAT -> {
                float[] a = new float[length];
                MemorySegment.copy(in, FLOAT, from, a, 0, length);
                yield a;
            }
        };
    }

    private Object readExistingArray(ElementType element) throws IOException {
        Object array = readArray(element);
        if (array == null) {
            throw new IOException("expected an array, found none");
        }
        return array;
    }

    public byte[] readBytes() throws IOException {
        return (byte[]) readExistingArray(ElementType.BYTE);
    }

    /** Reads an array of characters that is not null. */
    public char[] readChars() throws IOException {
        int length = readCount();
        long from = advance((long) length * Character.BYTES);
        char[] a = new char[length];
        MemorySegment.copy(in, CHAR, from, a, 0, length);
        return a;
    }

    /** Reads an array of long integers that is not null. */
    public long[] readLongs() throws IOException {
        int length = readCount();
        long from = advance((long) length * Long.BYTES);
        long[] a = new long[length];
        MemorySegment.copy(in, LONG, from, a, 0, length);
        return a;
    }

    public int[] readInts() throws IOException {
        return (int[]) readExistingArray(ElementType.INT);
    }

    /** Reads an array of integers, or null. */
    public int @Nullable [] readOptionalInts() throws IOException {
        return (int[]) readArray(ElementType.INT);
    }

    public float[] readFloats() throws IOException {
        return (float[]) readExistingArray(ElementType.FLOAT);
    }

    public short[] readShorts() throws IOException {
        return (short[]) readExistingArray(ElementType.SHORT);
    }

    /** Reads several columns of floats. */
    public float[][] readFloatArrays() throws IOException {
        float[][] columns = readOptionalFloatArrays();
        if (columns == null) {
            throw new IOException("expected columns, found none");
        }
        return columns;
    }

    /** Reads several columns of floats, or null. */
    public float @Nullable [][] readOptionalFloatArrays() throws IOException {
        int count = readInt();
        if (count == ColumnWriter.ABSENT) {
            return null;
        }
        if (count < 0 || count > end - position) {
            throw new IOException("expected a number of columns from 0 to " + (end - position) + ", found " + count);
        }
        float[][] columns = new float[count][];
        for (int i = 0; i < count; i++) {
            columns[i] = (float[]) readArray(ElementType.FLOAT);
        }
        return columns;
    }

    /** Reads all columns of a class of kinds. */
    public <C extends Enum<C> & ColumnKind> ColumnSet<C> readColumns(Class<C> kinds) throws IOException {
        C[] kindValues = kinds.getEnumConstants();
        @Nullable
        Object[] columns = new Object[kindValues.length];
        for (C kind : kindValues) {
            columns[kind.ordinal()] = readArray(kind.element());
        }
        return ColumnSet.of(kinds, columns);
    }

    /**
     * Verifies that no data is left.
     *
     * @throws IOException if there is
     */
    public void expectEnd() throws IOException {
        if (position != end) {
            throw new IOException("expected the end of the data, found " + (end - position) + " more bytes");
        }
    }

    private long advance(long bytes) throws IOException {
        if (bytes > end - position) {
            throw new EOFException("unexpected end of the data: " + (bytes - (end - position)) + " bytes are missing");
        }
        long from = position;
        position += bytes;
        return from;
    }
}
