package lightning.format.exr;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.zip.DataFormatException;

/** Reader for the blocks of cosines of a DWA chunk. */
final class DwaBlockReader {
    /** High byte of a number that stands for some zeros; its low byte says how many, 0 for all that are left. */
    static final int ZEROS = 0xFF00;

    private final DwaLayout layout;
    private final short[] ac;
    private final short[] dc;
    private int nextAc;

    /**
     * @param ac cosines without the first one of each block, zeros as runs
     * @param dc first cosines of all blocks
     */
    DwaBlockReader(DwaLayout layout, short[] ac, short[] dc) {
        this.layout = layout;
        this.ac = ac;
        this.dc = dc;
    }

    /** Writes all channels that are stored as cosines. */
    void read(ByteBuffer out) throws DataFormatException {
        int blocks = layout.blocksAcross() * layout.blocksDown();
        int firstDc = 0;
        for (int[] set : layout.sets()) {
            float[][] values = new float[set.length][DwaLayout.BLOCK];
            for (int b = 0; b < blocks; b++) {
                for (int i = 0; i < set.length; i++) {
                    readBlock(dc[firstDc + i * blocks + b], values[i]);
                }
                if (set.length > 1) {
                    toColors(values);
                }
                for (int i = 0; i < set.length; i++) {
                    write(set[i], b, values[i], out);
                }
            }
            firstDc += set.length * blocks;
        }
    }

    private void readBlock(short first, float[] to) throws DataFormatException {
        Arrays.fill(to, 0);
        to[0] = Float.float16ToFloat(first);
        for (int n = 1; n < DwaLayout.BLOCK; nextAc++) {
            DamagedData.rejectIf(nextAc == ac.length);
            short value = ac[nextAc];
            if ((value & ZEROS) == ZEROS) {
                int zeros = value & 0xFF;
                n += zeros == 0 ? DwaLayout.BLOCK : zeros;
            } else {
                to[CosineTransform.index(n++)] = Float.float16ToFloat(value);
            }
        }
        CosineTransform.invert(to);
    }

    /** Changes luminance and differences by Rec. 709, with the constants of the format, to red, green and blue. */
    private static void toColors(float[][] values) {
        for (int i = 0; i < DwaLayout.BLOCK; i++) {
            float luminance = values[0][i];
            float blue = values[1][i];
            float red = values[2][i];
            values[0][i] = luminance + 1.5747f * red;
            values[1][i] = luminance - 0.1873f * blue - 0.4682f * red;
            values[2][i] = luminance + 1.8556f * blue;
        }
    }

    private void write(int channel, int number, float[] values, ByteBuffer out) {
        ExrBlock block = layout.block();
        ExrChannel c = block.channels().get(channel);
        int left = number % layout.blocksAcross() * DwaLayout.SIDE;
        int top = number / layout.blocksAcross() * DwaLayout.SIDE;
        int start = block.channelOffsets()[channel];
        for (int y = 0; y < Math.min(DwaLayout.SIDE, block.height() - top); y++) {
            int line = (int) ((top + y) * block.bytesPerLine()) + start;
            for (int x = 0; x < Math.min(DwaLayout.SIDE, block.width() - left); x++) {
                short bits = Float.floatToFloat16(values[y * DwaLayout.SIDE + x]);
                short light = c.perceptual() && layout.rules().get(channel).color() < 0 ? bits : DwaCurve.fromCurve(bits);
                c.type().put(out, line + (left + x) * c.type().bytes(), Float.float16ToFloat(light));
            }
        }
    }
}
