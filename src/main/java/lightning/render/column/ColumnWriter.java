package lightning.render.column;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.WritableByteChannel;
import java.util.zip.CRC32C;

/**
 * Writes columns one behind the other: numbers, and arrays behind their lengths, least byte first. At the end stands a checksum of all
 * that is before it.
 */
public final class ColumnWriter {
    /** The length of an array that is not there. */
    static final int ABSENT = -1;
    private static final int ROOM = 1 << 18;

    private final WritableByteChannel out;
    private final ByteBuffer room = ByteBuffer.allocateDirect(ROOM).order(ByteOrder.LITTLE_ENDIAN);
    private final CRC32C sum = new CRC32C();

    /** @param out takes all bytes it is given, or throws */
    public ColumnWriter(WritableByteChannel out) {
        this.out = out;
    }

    public void number(int v) throws IOException {
        free(Integer.BYTES);
        room.putInt(v);
    }

    public void longNumber(long v) throws IOException {
        free(Long.BYTES);
        room.putLong(v);
    }

    /** An array of a type that {@link ElementType} has, or null. */
    public void array(Object column) throws IOException {
        switch (column) {
            case null -> number(ABSENT);
            case byte[] a -> {
                number(a.length);
                for (int at = 0, n; at < a.length; at += n) {
                    n = free(Byte.BYTES, a.length - at);
                    room.put(a, at, n);
                }
            }
            case short[] a -> {
                number(a.length);
                for (int at = 0, n; at < a.length; at += n) {
                    n = free(Short.BYTES, a.length - at);
                    room.asShortBuffer().put(a, at, n);
                    room.position(room.position() + n * Short.BYTES);
                }
            }
            case int[] a -> {
                number(a.length);
                for (int at = 0, n; at < a.length; at += n) {
                    n = free(Integer.BYTES, a.length - at);
                    room.asIntBuffer().put(a, at, n);
                    room.position(room.position() + n * Integer.BYTES);
                }
            }
            case float[] a -> {
                number(a.length);
                for (int at = 0, n; at < a.length; at += n) {
                    n = free(Float.BYTES, a.length - at);
                    room.asFloatBuffer().put(a, at, n);
                    room.position(room.position() + n * Float.BYTES);
                }
            }
            default -> throw new IllegalArgumentException("no column holds " + column.getClass());
        }
    }

    /** Several columns of floats, or null. */
    public void arrays(float[][] columns) throws IOException {
        number(columns == null ? ABSENT : columns.length);
        for (float[] column : columns == null ? new float[0][] : columns) {
            array(column);
        }
    }

    /** All columns of a set, and which it lacks. */
    public <C extends Enum<C> & ColumnKind> void columns(ColumnSet<C> columns) throws IOException {
        for (C kind : columns.kinds()) {
            array(columns.get(kind));
        }
    }

    /** Writes the checksum; nothing may follow. */
    public void end() throws IOException {
        empty();
        room.putLong(sum.getValue());
        room.flip();
        put();
    }

    private void free(int bytes) throws IOException {
        if (room.remaining() < bytes) {
            empty();
        }
    }

    /** Makes room for one element at least; returns for how many of those left there is. */
    private int free(int each, int left) throws IOException {
        free(each);
        return Math.min(left, room.remaining() / each);
    }

    private void empty() throws IOException {
        room.flip();
        sum.update(room.duplicate());
        put();
    }

    private void put() throws IOException {
        while (room.hasRemaining()) {
            out.write(room);
        }
        room.clear();
    }
}
