package lightning.format.exr;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.zip.DataFormatException;

/**
 * Decoder of PIZ chunks: 16-bit numbers of each channel, numbered by the values that occur, as a Haar wavelet in Huffman codes. A float
 * is two numbers.
 */
final class PizDecoder {
    /** Bytes of a set of all 16-bit values. */
    private static final int SET_BYTES = 8192;

    private PizDecoder() {}

    static byte[] decode(byte[] compressed, ExrBlock block) throws DataFormatException {
        try {
            ByteBuffer in = ByteBuffer.wrap(compressed).order(ByteOrder.LITTLE_ENDIAN);
            short[] values = new short[Short.toUnsignedInt((short) -1) + 1];
            int maxIndex = readValues(in, values);
            int length = in.getInt();
            DamagedData.rejectIf(length < 0 || length > in.remaining());
            short[] numbers = HuffmanDecoder.decode(in.slice(in.position(), length), (int) (block.byteCount() / Short.BYTES));
            int start = 0;
            for (ExrChannel channel : block.channels()) {
                int step = channel.type().bytes() / Short.BYTES;
                for (int i = 0; i < step; i++) {
                    HaarWavelet.decode(numbers, start + i, block.width(), step, block.height(), block.width() * step, maxIndex);
                }
                start += block.width() * block.height() * step;
            }
            return interleave(numbers, values, block);
        } catch (BufferUnderflowException e) {
            throw (DataFormatException) new DataFormatException().initCause(e);
        }
    }

    /**
     * Reads the set of values that occur, of which 0 is always one.
     *
     * @param values receives the value of each index
     * @return the largest index
     */
    private static int readValues(ByteBuffer in, short[] values) throws DataFormatException {
        int first = Short.toUnsignedInt(in.getShort());
        int last = Short.toUnsignedInt(in.getShort());
        DamagedData.rejectIf(last >= SET_BYTES);
        byte[] set = new byte[SET_BYTES];
        if (first <= last) {
            in.get(set, first, last - first + 1);
        }
        set[0] |= 1;
        int count = 0;
        for (int v = 0; v < values.length; v++) {
            if ((set[v / Byte.SIZE] >> v % Byte.SIZE & 1) != 0) {
                values[count++] = (short) v;
            }
        }
        return count - 1;
    }

    /** Changes numbers channel by channel to lines of all channels. */
    private static byte[] interleave(short[] numbers, short[] values, ExrBlock block) {
        ByteBuffer out = ByteBuffer.allocate((int) block.byteCount()).order(ByteOrder.LITTLE_ENDIAN);
        for (int y = 0; y < block.height(); y++) {
            int start = 0;
            for (ExrChannel channel : block.channels()) {
                int count = block.width() * channel.type().bytes() / Short.BYTES;
                for (int i = start + y * count; i < start + (y + 1) * count; i++) {
                    out.putShort(values[Short.toUnsignedInt(numbers[i])]);
                }
                start += block.height() * count;
            }
        }
        return out.array();
    }
}
