package lightning.format.exr;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.zip.DataFormatException;

/**
 * Decoder of B44 and B44A chunks: halves in blocks of 4 × 4 as a first value and 15 differences of 6 bits, or as one value for all. Values are
 * ordered bits: a larger number is a larger half. All other channels are stored as they are.
 */
final class B44Decoder {
    private static final int SIDE = 4;
    private static final int BLOCK = SIDE * SIDE;
    private static final int FLAT_BYTES = 3;
    private static final int BLOCK_BYTES = 14;
    /** Shifts from here on mark a block with one value. */
    private static final int FLAT_SHIFT = 13;
    private static final int DIFFERENCE_BITS = 6;
    /** Difference that stands for 0. */
    private static final int NO_DIFFERENCE = 1 << DIFFERENCE_BITS - 1;
    private static final int SIGN = 0x8000;
    /** Factor of the logarithm in which channels that look equal in equal steps are stored. */
    private static final double LOG_FACTOR = 8;

    private final ByteBuffer in;
    private final ExrBlock block;
    private final ByteBuffer out;
    private final int lineBytes;

    private B44Decoder(byte[] compressed, ExrBlock block) {
        in = ByteBuffer.wrap(compressed);
        this.block = block;
        out = ByteBuffer.allocate((int) block.byteCount()).order(ByteOrder.LITTLE_ENDIAN);
        lineBytes = (int) block.bytesPerLine();
    }

    static byte[] decode(byte[] compressed, ExrBlock block) throws DataFormatException {
        var decoder = new B44Decoder(compressed, block);
        int[] offsets = block.channelOffsets();
        for (int c = 0; c < offsets.length; c++) {
            ExrChannel channel = block.channels().get(c);
            if (channel.type() == ExrType.HALF) {
                decoder.readBlocks(offsets[c], channel.perceptual());
            } else {
                decoder.copy(offsets[c], channel.type().bytes() * block.width());
            }
        }
        return decoder.out.array();
    }

    private void require(int bytes) throws DataFormatException {
        DamagedData.rejectIf(in.remaining() < bytes);
    }

    private void copy(int offset, int bytes) throws DataFormatException {
        require(bytes * block.height());
        for (int y = 0; y < block.height(); y++) {
            in.get(out.array(), y * lineBytes + offset, bytes);
        }
    }

    private void readBlocks(int offset, boolean isPerceptual) throws DataFormatException {
        int[] values = new int[BLOCK];
        for (int top = 0; top < block.height(); top += SIDE) {
            for (int left = 0; left < block.width(); left += SIDE) {
                readBlock(values);
                for (int i = 0; i < BLOCK; i++) {
                    int x = left + i % SIDE;
                    int y = top + i / SIDE;
                    if (x < block.width() && y < block.height()) {
                        short half = half(values[i]);
                        out.putShort(y * lineBytes + offset + x * Short.BYTES, isPerceptual ? logarithm(half) : half);
                    }
                }
            }
        }
    }

    /** Reads a block: its first column downward, then each next column from the one before it. */
    private void readBlock(int[] values) throws DataFormatException {
        require(FLAT_BYTES);
        int first = Short.toUnsignedInt(in.getShort());
        int shift = Byte.toUnsignedInt(in.get(in.position())) >> Byte.SIZE - DIFFERENCE_BITS;
        if (shift >= FLAT_SHIFT) {
            in.get();
            Arrays.fill(values, first);
            return;
        }
        require(BLOCK_BYTES - Short.BYTES);
        long bits = (long) in.getInt() << Long.SIZE / 2 | Integer.toUnsignedLong(in.getInt());
        long rest = Integer.toUnsignedLong(in.getInt());
        values[0] = first;
        for (int n = 1; n < BLOCK; n++) {
            int at = n * DIFFERENCE_BITS;
            int difference = difference(bits, rest, at);
            int column = n / SIDE;
            int row = n % SIDE;
            int before = column == 0 ? values[(row - 1) * SIDE] : values[row * SIDE + column - 1];
            values[row * SIDE + column] = before + (difference - NO_DIFFERENCE << shift) & 0xFFFF;
        }
    }

    /** Returns six bits of 96. */
    private static int difference(long bits, long rest, int at) {
        int end = at + DIFFERENCE_BITS;
        long value = end <= Long.SIZE ? bits >>> Long.SIZE - end : bits << end - Long.SIZE | rest >>> Long.SIZE + Integer.SIZE - end;
        return (int) value & (1 << DIFFERENCE_BITS) - 1;
    }

    private static short half(int ordered) {
        return (short) ((ordered & SIGN) != 0 ? ordered & ~SIGN : ~ordered);
    }

    private static short logarithm(short half) {
        float value = Float.float16ToFloat(half);
        return Float.isFinite(value) && value > 0 ? Float.floatToFloat16((float) (LOG_FACTOR * Math.log(value))) : 0;
    }
}
