package lightning.render.cache;

import java.util.Arrays;
import java.util.BitSet;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import lightning.render.shading.SampleMean;
import lightning.render.trace.SampleCells;

/**
 * Samples of some pixels of a tile. Blocks may contain other pixels, too, whose samples were needed before and may be needed again;
 * no pixel is in two blocks.
 *
 * @param cells  samples of each pixel
 * @param pixels indices of the pixels that use their samples, ascending
 * @param blocks samples of these pixels and possibly others, at most 1024 in each block
 */
public record FineSamples(SampleCells cells, short[] pixels, SampleBlock[] blocks) {
    // Arrays in a record: written once by their creator.

    private static final short[] NO_PIXELS = {};

    /** Returns samples of no pixel. */
    public static FineSamples none(SampleCells cells) {
        return new FineSamples(cells, NO_PIXELS, new SampleBlock[0]);
    }

    /** Returns the pixels as a set. */
    public BitSet pixelSet() {
        BitSet set = new BitSet();
        for (short pixel : pixels) {
            set.set(pixel);
        }
        return set;
    }

    /** Receives the mean color of a pixel's samples. */
    @FunctionalInterface
    interface MeanConsumer {
        void accept(int pixel, float red, float green, float blue);
    }

    /** Passes on the mean of each pixel that uses its samples; {@code means} returns those of a block. */
    void forEachMean(Function<SampleBlock, float[][]> means, MeanConsumer consumer) {
        BitSet used = pixelSet();
        for (SampleBlock block : blocks) {
            float[][] colors = means.apply(block);
            for (int i = 0; i < block.pixels().length; i++) {
                if (used.get(block.pixels()[i])) {
                    consumer.accept(block.pixels()[i], colors[0][i], colors[1][i], colors[2][i]);
                }
            }
        }
    }

    /** Returns the means of a block's pixels whose samples have the given colors. */
    float[][] means(SampleBlock block, float[][] colors) {
        return SampleMean.ofPixels(block.pixels().length, cells.count(), colors);
    }

    /** Returns the same samples with other rows, each computed from a block and its means. */
    public FineSamples map(UnaryOperator<SampleBlock> change) {
        return new FineSamples(cells, pixels, Arrays.stream(blocks).map(change).toArray(SampleBlock[]::new));
    }
}
