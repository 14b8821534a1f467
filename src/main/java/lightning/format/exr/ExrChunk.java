package lightning.format.exr;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.zip.DataFormatException;
import java.util.zip.Deflater;
import java.util.zip.Inflater;

/** The numbers of up to 16 lines, as they are before they are compressed. */
public final class ExrChunk {
    /** What most writers of this format take: on noise of floats more effort gains a hundredth. */
    private static final int EFFORT = 4;

    private final ExrHeader header;
    private final int[] starts;
    private final int line;
    private final ByteBuffer numbers;

    ExrChunk(ExrHeader header, int[] starts, byte[] numbers) {
        this.header = header;
        this.starts = starts;
        this.line = (int) header.bytesPerLine();
        this.numbers = ByteBuffer.wrap(numbers).order(ByteOrder.LITTLE_ENDIAN);
    }

    /** A chunk of zeros; {@code index} from 0 to before {@link ExrHeader#chunks}. */
    public ExrChunk(ExrHeader header, int index) {
        this(header, header.starts(), new byte[Math.toIntExact(header.bytesPerLine() * header.lines(index))]);
    }

    /**
     * Puts a number.
     *
     * @param channel its place in the header
     * @param y       from the chunk's first line
     */
    public void put(int channel, int x, int y, float v) {
        ExrType type = header.channels().get(channel).type();
        type.put(numbers, y * line + starts[channel] + x * type.bytes(), v);
    }

    float get(int channel, int x, int y) {
        ExrType type = header.channels().get(channel).type();
        return type.get(numbers, y * line + starts[channel] + x * type.bytes());
    }

    /**
     * The chunk as a file has it: all bytes of even places before those of odd ones, each as its difference from the one before, by
     * zlib; as it is where that is no shorter.
     */
    public byte[] packed() {
        byte[] raw = numbers.array();
        byte[] apart = new byte[raw.length];
        int half = (raw.length + 1) / 2;
        for (int i = 0; i < raw.length; i++) {
            apart[(i & 1) * half + i / 2] = raw[i];
        }
        for (int i = raw.length - 1; i > 0; i--) {
            apart[i] = (byte) (apart[i] - apart[i - 1] + 128);
        }
        try (Deflater deflater = new Deflater(EFFORT)) {
            deflater.setInput(apart);
            deflater.finish();
            byte[] packed = new byte[raw.length];
            int length = deflater.deflate(packed);
            return deflater.finished() && length < raw.length ? Arrays.copyOf(packed, length) : raw;
        }
    }

    /**
     * The reverse of {@link #packed}.
     *
     * @throws DataFormatException if it does not give exactly so many bytes
     */
    static byte[] unpacked(byte[] packed, int length) throws DataFormatException {
        if (packed.length == length) {
            return packed;
        }
        byte[] apart = new byte[length];
        try (Inflater inflater = new Inflater()) {
            inflater.setInput(packed);
            if (inflater.inflate(apart) != length || inflater.inflate(new byte[1]) != 0) {
                throw new DataFormatException();
            }
        }
        for (int i = 1; i < length; i++) {
            apart[i] = (byte) (apart[i - 1] + apart[i] - 128);
        }
        byte[] raw = new byte[length];
        int half = (length + 1) / 2;
        for (int i = 0; i < length; i++) {
            raw[i] = apart[(i & 1) * half + i / 2];
        }
        return raw;
    }
}
