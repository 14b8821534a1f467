package lightning.format.exr;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Uncompressed pixel data of some scan lines or of a tile. */
public final class ExrChunk {
    private final ExrBlock block;
    private final ExrCompression compression;
    private final int[] channelOffsets;
    private final int lineBytes;
    private final ByteBuffer buffer;

    ExrChunk(ExrBlock block, ExrCompression compression, byte[] numbers) {
        this.block = block;
        this.compression = compression;
        this.channelOffsets = block.channelOffsets();
        this.lineBytes = (int) block.bytesPerLine();
        this.buffer = ByteBuffer.wrap(numbers).order(ByteOrder.LITTLE_ENDIAN);
    }

    /**
     * Creates a chunk of zeros.
     *
     * @param index 0 to {@link ExrHeader#chunkCount} − 1
     */
    public ExrChunk(ExrHeader header, int index) {
        this(header.block(index), header.compression(), new byte[Math.toIntExact(header.block(index).byteCount())]);
    }

    /**
     * Sets a value.
     *
     * @param channel index of the channel in the header
     * @param y line within the chunk
     */
    public void put(int channel, int x, int y, float v) {
        ExrType type = block.channels().get(channel).type();
        type.put(buffer, y * lineBytes + channelOffsets[channel] + x * type.bytes(), v);
    }

    /**
     * Reads the values of a line.
     *
     * @param y  line within the chunk
     * @param to receives one value for each pixel of the line
     */
    void readLine(int channel, int y, float[] to) {
        ExrType type = block.channels().get(channel).type();
        int first = y * lineBytes + channelOffsets[channel];
        int bytes = type.bytes();
        for (int x = 0; x < block.width(); x++) {
            to[x] = type.get(buffer, first + x * bytes);
        }
    }

    /** Returns the chunk's bytes in the file: compressed, or as they are if that is not shorter. */
    public byte[] compress() {
        return compression.compress(buffer.array(), block);
    }
}
