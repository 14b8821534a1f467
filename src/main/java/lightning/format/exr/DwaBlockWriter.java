package lightning.format.exr;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;

/** Writer for the blocks of cosines of a DWA chunk: colors of halves. */
final class DwaBlockWriter {
    /** Error of a cosine that the smallest step of both tables may have: level 45 of the format, as other writers use it. */
    private static final float BASE_ERROR = 45 / 100_000f;
    /** Steps of luminance and of color differences by frequency, line by line (ITU-T T.81, tables K.1 and K.2). */
    private static final int[] LUMINANCE_STEPS = {16, 11, 10, 16, 24, 40, 51, 61, 12, 12, 14, 19, 26, 58, 60, 55, 14, 13, 16, 24, 40, 57,
        69,
        56, 14, 17, 22, 29, 51, 87, 80, 62, 18, 22, 37, 56, 68, 109, 103, 77, 24, 35, 55, 64, 81, 104, 113, 92, 49, 64, 78, 87, 103, 121,
        120, 101, 72, 92, 95, 98, 112, 100, 103, 99};
    private static final int[] DIFFERENCE_STEPS = {17, 18, 24, 47, 99, 99, 99, 99, 18, 21, 26, 66, 99, 99, 99, 99, 24, 26, 56, 99, 99, 99,
        99, 99, 47, 66, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99,
        99, 99, 99, 99, 99, 99, 99, 99, 99};
    private static final int MIN_LUMINANCE_STEP = 10;
    private static final int MIN_DIFFERENCE_STEP = 17;
    private static final int MANTISSA_BITS = 10;

    private final DwaLayout layout;
    private final ByteArrayOutputStream ac = new ByteArrayOutputStream();
    private final ByteArrayOutputStream dc = new ByteArrayOutputStream();

    DwaBlockWriter(DwaLayout layout) {
        this.layout = layout;
    }

    /** Returns the cosines without the first one of each block, zeros as runs; little-endian. */
    byte[] ac() {
        return ac.toByteArray();
    }

    /** Returns the first cosines of all blocks; little-endian. */
    byte[] dc() {
        return dc.toByteArray();
    }

    /** Writes all channels that are stored as cosines. */
    void write(ByteBuffer in) {
        int blocks = layout.blocksAcross() * layout.blocksDown();
        for (int[] set : layout.sets()) {
            short[][] means = new short[set.length][blocks];
            float[][] values = new float[set.length][DwaLayout.BLOCK];
            for (int b = 0; b < blocks; b++) {
                for (int i = 0; i < set.length; i++) {
                    read(set[i], b, in, values[i]);
                }
                if (set.length > 1) {
                    toDifferences(values);
                }
                for (int i = 0; i < set.length; i++) {
                    CosineTransform.transform(values[i]);
                    means[i][b] = Float.floatToFloat16(values[i][0]);
                    writeBlock(values[i], i == 0);
                }
            }
            for (short[] ofChannel : means) {
                for (short mean : ofChannel) {
                    put(dc, mean);
                }
            }
        }
    }

    /** Reads a block on the curve. Beyond the picture the last column and line are repeated. */
    private void read(int channel, int number, ByteBuffer in, float[] to) {
        ExrBlock block = layout.block();
        int left = number % layout.blocksAcross() * DwaLayout.SIDE;
        int top = number / layout.blocksAcross() * DwaLayout.SIDE;
        int start = block.channelOffsets()[channel];
        for (int i = 0; i < DwaLayout.BLOCK; i++) {
            int x = Math.min(left + i % DwaLayout.SIDE, block.width() - 1);
            int y = Math.min(top + i / DwaLayout.SIDE, block.height() - 1);
            short light = in.getShort((int) (y * block.bytesPerLine()) + start + x * Short.BYTES);
            to[i] = Float.float16ToFloat(DwaCurve.toCurve(light));
        }
    }

    /** Changes red, green and blue to luminance and differences by Rec. 709, with the constants of the format. */
    private static void toDifferences(float[][] values) {
        for (int i = 0; i < DwaLayout.BLOCK; i++) {
            float red = values[0][i];
            float green = values[1][i];
            float blue = values[2][i];
            values[0][i] = 0.2126f * red + 0.7152f * green + 0.0722f * blue;
            values[1][i] = -0.1146f * red - 0.3854f * green + 0.5f * blue;
            values[2][i] = 0.5f * red - 0.4542f * green - 0.0458f * blue;
        }
    }

    private void writeBlock(float[] values, boolean isLuminance) {
        int zeros = 0;
        for (int n = 1; n < DwaLayout.BLOCK; n++) {
            int index = CosineTransform.index(n);
            float step = isLuminance ? (float) LUMINANCE_STEPS[index] / MIN_LUMINANCE_STEP
                    : (float) DIFFERENCE_STEPS[index] / MIN_DIFFERENCE_STEP;
            short value = quantize(values[index], BASE_ERROR * step);
            if (value == 0) {
                zeros++;
            } else {
                if (zeros > 0) {
                    put(ac, (short) (DwaBlockReader.ZEROS | zeros));
                    zeros = 0;
                }
                put(ac, value);
            }
        }
        if (zeros > 0) {
            put(ac, (short) DwaBlockReader.ZEROS);
        }
    }

    /** Returns the half with the fewest bits that is not farther from a value than an error; 0 for a small value. */
    private static short quantize(float value, float error) {
        if (Math.abs(value) <= error) {
            return 0;
        }
        short exact = Float.floatToFloat16(value);
        for (int dropped = MANTISSA_BITS; dropped > 0; dropped--) {
            // A carry into the exponent is the next power of 2.
            short rounded = (short) (exact + (1 << dropped - 1) & -1 << dropped);
            if (Math.abs(Float.float16ToFloat(rounded) - value) <= error) {
                return rounded;
            }
        }
        return exact;
    }

    private static void put(ByteArrayOutputStream out, short value) {
        out.write(value);
        out.write(value >> Byte.SIZE);
    }
}
