package lightning.format.exr;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.zip.DataFormatException;
import java.util.zip.Deflater;
import java.util.zip.Inflater;

/** Uncompressed pixel data of up to 16 scan lines. */
public final class ExrChunk {
    /** Compression level that most writers of this format use; on noisy floats more effort gains 1 %. */
    private static final int COMPRESSION_LEVEL = 4;

    private final ExrHeader header;
    private final int[] channelOffsets;
    private final int lineBytes;
    private final ByteBuffer buffer;

    ExrChunk(ExrHeader header, int[] channelOffsets, byte[] numbers) {
        this.header = header;
        this.channelOffsets = channelOffsets;
        this.lineBytes = (int) header.bytesPerLine();
        this.buffer = ByteBuffer.wrap(numbers).order(ByteOrder.LITTLE_ENDIAN);
    }

    /**
     * Creates a chunk of zeros.
     *
     * @param index 0 to {@link ExrHeader#chunkCount} − 1
     */
    public ExrChunk(ExrHeader header, int index) {
        this(header, header.channelOffsets(), new byte[Math.toIntExact(header.bytesPerLine() * header.lineCount(index))]);
    }

    /**
     * Sets a value.
     *
     * @param channel index of the channel in the header
     * @param y line within the chunk
     */
    public void put(int channel, int x, int y, float v) {
        ExrType type = header.channels().get(channel).type();
        type.put(buffer, y * lineBytes + channelOffsets[channel] + x * type.bytes(), v);
    }

    float get(int channel, int x, int y) {
        ExrType type = header.channels().get(channel).type();
        return type.get(buffer, y * lineBytes + channelOffsets[channel] + x * type.bytes());
    }

    /**
     * Returns the chunk's bytes in the file: even bytes before odd bytes, delta-encoded, compressed by zlib; uncompressed if
     * that is not shorter.
     */
    public byte[] compress() {
        byte[] raw = buffer.array();
        byte[] predicted = new byte[raw.length];
        int half = (raw.length + 1) / 2;
        for (int i = 0; i < raw.length; i++) {
            predicted[(i & 1) * half + i / 2] = raw[i];
        }
        for (int i = raw.length - 1; i > 0; i--) {
            predicted[i] = (byte) (predicted[i] - predicted[i - 1] + 128);
        }
        try (Deflater deflater = new Deflater(COMPRESSION_LEVEL)) {
            deflater.setInput(predicted);
            deflater.finish();
            byte[] compressed = new byte[raw.length];
            int length = deflater.deflate(compressed);
            return deflater.finished() && length < raw.length ? Arrays.copyOf(compressed, length) : raw;
        }
    }

    /**
     * Decompresses a chunk; inverse of {@link #compress}.
     *
     * @throws DataFormatException if the result has another length
     */
    static byte[] decompress(byte[] compressed, int length) throws DataFormatException {
        if (compressed.length == length) {
            return compressed;
        }
        byte[] predicted = new byte[length];
        try (Inflater inflater = new Inflater()) {
            inflater.setInput(compressed);
            if (inflater.inflate(predicted) != length || inflater.inflate(new byte[1]) != 0) {
                throw new DataFormatException();
            }
        }
        for (int i = 1; i < length; i++) {
            predicted[i] = (byte) (predicted[i - 1] + predicted[i] - 128);
        }
        byte[] raw = new byte[length];
        int half = (length + 1) / 2;
        for (int i = 0; i < length; i++) {
            raw[i] = predicted[(i & 1) * half + i / 2];
        }
        return raw;
    }
}
