package lightning.format.exr;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.SeekableByteChannel;
import java.util.Map;
import java.util.TreeMap;

/**
 * Writes a file chunk by chunk, so that a picture of many layers needs never be in memory as a whole. Chunks may come from several
 * threads and in any order; the file has them from the top.
 */
public final class ExrWriter {
    private final SeekableByteChannel file;
    private final ExrHeader header;
    private final long table;
    private final long[] places;
    private final Map<Integer, byte[]> early = new TreeMap<>();
    private int next;

    /**
     * Writes the header.
     *
     * @param file empty
     */
    public ExrWriter(SeekableByteChannel file, ExrHeader header) throws IOException {
        this.file = file;
        this.header = header;
        places = new long[header.chunks()];
        byte[] begin = header.bytes();
        table = begin.length;
        write(ByteBuffer.wrap(begin), 0);
        file.position(table + (long) Long.BYTES * places.length);
    }

    /** Writes a chunk, or keeps it until those before it have come. */
    public synchronized void put(int index, byte[] packed) throws IOException {
        early.put(index, packed);
        for (byte[] now = early.remove(next); now != null; now = early.remove(next)) {
            places[next] = file.position();
            ByteBuffer buffer = ByteBuffer.allocate(2 * Integer.BYTES + now.length).order(ByteOrder.LITTLE_ENDIAN);
            buffer.putInt(next * ExrHeader.LINES).putInt(now.length).put(now).flip();
            write(buffer, file.position());
            next++;
        }
    }

    /**
     * Writes where the chunks stand.
     *
     * @throws IllegalStateException if any has not come
     */
    public synchronized void finish() throws IOException {
        if (next < header.chunks()) {
            throw new IllegalStateException(next + " of " + header.chunks() + " chunks have come");
        }
        ByteBuffer buffer = ByteBuffer.allocate(Long.BYTES * places.length).order(ByteOrder.LITTLE_ENDIAN);
        for (long place : places) {
            buffer.putLong(place);
        }
        write(buffer.flip(), table);
    }

    private void write(ByteBuffer bytes, long at) throws IOException {
        file.position(at);
        while (bytes.hasRemaining()) {
            file.write(bytes);
        }
    }
}
