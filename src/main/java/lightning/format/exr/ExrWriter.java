package lightning.format.exr;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.SeekableByteChannel;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Writer that stores a file chunk by chunk, so that an image with many layers is never in memory as a whole. Chunks may
 * arrive from several threads in any order; the file contains them from top to bottom.
 */
public final class ExrWriter {
    private final SeekableByteChannel file;
    private final List<ExrHeader> parts;
    private final long tableOffset;
    /** Place of each chunk of each part; 0 for one that was not written. */
    private final long[][] chunkOffsets;
    private final Map<Integer, List<Chunk>> pending = new TreeMap<>();
    private int next;

    /**
     * Compressed chunk of a part.
     *
     * @param part number of the part, from 0
     * @param index 0 to {@link ExrHeader#chunkCount} − 1
     */
    public record Chunk(int part, int index, byte[] compressed) {
        // An array in a record: handed over to the writer.
    }

    /**
     * Writes the header of a file with one part.
     *
     * @param file empty output file
     */
    public ExrWriter(SeekableByteChannel file, ExrHeader header) throws IOException {
        this(file, List.of(header));
    }

    /**
     * Writes the headers of a file.
     *
     * @param file empty output file
     * @param parts headers of its parts, at least one; each of several has an attribute {@link ExrHeader#NAME} of its own
     */
    public ExrWriter(SeekableByteChannel file, List<ExrHeader> parts) throws IOException {
        this.file = file;
        this.parts = parts;
        chunkOffsets = parts.stream().map(part -> new long[part.chunkCount()]).toArray(long[][]::new);
        byte[] headerBytes = ExrHeader.encode(parts);
        tableOffset = headerBytes.length;
        write(ByteBuffer.wrap(headerBytes), 0);
        file.position(tableOffset + tableBytes());
    }

    private long tableBytes() {
        return parts.stream().mapToLong(part -> (long) Long.BYTES * part.chunkCount()).sum();
    }

    /** Writes a chunk of a file with one part, or buffers it until its predecessors have arrived. */
    public void writeChunk(int index, byte[] compressed) throws IOException {
        writeChunks(index, List.of(new Chunk(0, index, compressed)));
    }

    /**
     * Writes some chunks, or buffers them until their predecessors have arrived.
     *
     * @param batch number of the batch: from 0, each once
     */
    public synchronized void writeChunks(int batch, List<Chunk> chunks) throws IOException {
        pending.put(batch, chunks);
        for (List<Chunk> ready = pending.remove(next); ready != null; ready = pending.remove(next)) {
            for (Chunk chunk : ready) {
                writeNow(chunk);
            }
            next++;
        }
    }

    private void writeNow(Chunk chunk) throws IOException {
        chunkOffsets[chunk.part][chunk.index] = file.position();
        ExrHeader header = parts.get(chunk.part);
        ByteBuffer buffer = ByteBuffer.allocate(3 * Integer.BYTES + chunk.compressed.length).order(ByteOrder.LITTLE_ENDIAN);
        if (parts.size() > 1) {
            buffer.putInt(chunk.part);
        }
        buffer.putInt(header.window().top() + chunk.index * header.compression().lines()).putInt(chunk.compressed.length)
                .put(chunk.compressed).flip();
        write(buffer, file.position());
    }

    /**
     * Writes the chunk offset tables.
     *
     * @throws IllegalStateException if a chunk is missing
     */
    public synchronized void finish() throws IOException {
        ByteBuffer buffer = ByteBuffer.allocate(Math.toIntExact(tableBytes())).order(ByteOrder.LITTLE_ENDIAN);
        for (long[] offsets : chunkOffsets) {
            for (long offset : offsets) {
                if (offset == 0) {
                    throw new IllegalStateException("a chunk was not written");
                }
                buffer.putLong(offset);
            }
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
