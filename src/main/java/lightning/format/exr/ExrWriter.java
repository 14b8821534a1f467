package lightning.format.exr;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.SeekableByteChannel;
import java.util.Map;
import java.util.TreeMap;

/**
 * Writer that stores a file chunk by chunk, so that an image with many layers is never in memory as a whole. Chunks may
 * arrive from several threads in any order; the file contains them from top to bottom.
 */
public final class ExrWriter {
    private final SeekableByteChannel file;
    private final ExrHeader header;
    private final long tableOffset;
    private final long[] chunkOffsets;
    private final Map<Integer, byte[]> pending = new TreeMap<>();
    private int next;

    /**
     * Writes the header.
     *
     * @param file empty output file
     */
    public ExrWriter(SeekableByteChannel file, ExrHeader header) throws IOException {
        this.file = file;
        this.header = header;
        chunkOffsets = new long[header.chunkCount()];
        byte[] headerBytes = header.encode();
        tableOffset = headerBytes.length;
        write(ByteBuffer.wrap(headerBytes), 0);
        file.position(tableOffset + (long) Long.BYTES * chunkOffsets.length);
    }

    /** Writes a chunk, or buffers it until its predecessors have arrived. */
    public synchronized void writeChunk(int index, byte[] compressed) throws IOException {
        pending.put(index, compressed);
        for (byte[] chunk = pending.remove(next); chunk != null; chunk = pending.remove(next)) {
            chunkOffsets[next] = file.position();
            ByteBuffer buffer = ByteBuffer.allocate(2 * Integer.BYTES + chunk.length).order(ByteOrder.LITTLE_ENDIAN);
            buffer.putInt(next * ExrHeader.LINES_PER_CHUNK).putInt(chunk.length).put(chunk).flip();
            write(buffer, file.position());
            next++;
        }
    }

    /**
     * Writes the chunk offset table.
     *
     * @throws IllegalStateException if a chunk is missing
     */
    public synchronized void finish() throws IOException {
        if (next < header.chunkCount()) {
            throw new IllegalStateException(next + " of " + header.chunkCount() + " chunks were written");
        }
        ByteBuffer buffer = ByteBuffer.allocate(Long.BYTES * chunkOffsets.length).order(ByteOrder.LITTLE_ENDIAN);
        for (long offset : chunkOffsets) {
            buffer.putLong(offset);
        }
        write(buffer.flip(), tableOffset);
    }

    private void write(ByteBuffer bytes, long offset) throws IOException {
        file.position(offset);
        while (bytes.hasRemaining()) {
            file.write(bytes);
        }
    }
}
