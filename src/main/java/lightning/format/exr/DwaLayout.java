package lightning.format.exr;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.format.exr.DwaRule.Scheme;

/**
 * Channels of a DWA chunk by their storage.
 *
 * @param block layout of the chunk
 * @param rules rule of each channel
 * @param sets channels stored as cosines together: red, green and blue of a color, or one channel. In the order of the chunk
 */
record DwaLayout(ExrBlock block, List<DwaRule> rules, List<int[]> sets) {
    /** Pixels along a side of a block of cosines. */
    static final int SIDE = 8;
    /** Number of values of a block of cosines. */
    static final int BLOCK = SIDE * SIDE;

    static DwaLayout of(ExrBlock block, List<DwaRule> rules) {
        List<ExrChannel> channels = block.channels();
        List<DwaRule> ofChannels = DwaRule.ofChannels(rules, channels);
        // Colors in the order of their first channels.
        Map<String, int[]> colors = new LinkedHashMap<>();
        for (int c = 0; c < channels.size(); c++) {
            int[] color = colors.computeIfAbsent(channels.get(c).prefix(), _ -> new int[] {-1, -1, -1});
            if (ofChannels.get(c).isColor()) {
                color[ofChannels.get(c).color()] = c;
            }
        }
        List<int[]> sets = new ArrayList<>(colors.values().stream().filter(color -> Arrays.stream(color).noneMatch(c -> c < 0)).toList());
        boolean[] isInColor = new boolean[channels.size()];
        sets.forEach(color -> Arrays.stream(color).forEach(c -> isInColor[c] = true));
        for (int c = 0; c < channels.size(); c++) {
            if (!isInColor[c] && ofChannels.get(c).scheme() == Scheme.COSINES) {
                sets.add(new int[] {c});
            }
        }
        return new DwaLayout(block, ofChannels, sets);
    }

    /** Returns whether all channels of colors are stored as cosines, as the format requires. */
    boolean isValid() {
        return sets.stream().flatMapToInt(Arrays::stream).allMatch(c -> rules.get(c).scheme() == Scheme.COSINES);
    }

    /** Returns the bytes of all channels of a storage. */
    int bytes(Scheme scheme) {
        int bytes = 0;
        for (int c = 0; c < rules.size(); c++) {
            bytes += rules.get(c).scheme() == scheme ? channelBytes(c) : 0;
        }
        return bytes;
    }

    /** Receiver of the two places of a byte. */
    @FunctionalInterface
    interface BytePlaces {
        /**
         * @param line   place among the lines of the chunk
         * @param stored place in a storage
         */
        void accept(int line, int stored);
    }

    /**
     * Visits the bytes of a storage without losses: one channel after the other; of runs the first bytes of all values of a channel, then
     * the second ones.
     */
    void forEachByte(Scheme scheme, BytePlaces visitor) {
        int[] offsets = block.channelOffsets();
        int lineBytes = (int) block.bytesPerLine();
        int start = 0;
        for (int c = 0; c < rules.size(); c++) {
            if (rules.get(c).scheme() == scheme) {
                int bytes = block.channels().get(c).type().bytes();
                int rowBytes = block.width() * bytes;
                for (int y = 0; y < block.height(); y++) {
                    for (int i = 0; i < rowBytes; i++) {
                        int at = scheme == Scheme.ZLIB ? y * rowBytes + i : i % bytes * pixels() + y * block.width() + i / bytes;
                        visitor.accept(y * lineBytes + offsets[c] + i, start + at);
                    }
                }
                start += channelBytes(c);
            }
        }
    }

    int channelBytes(int channel) {
        return block.channels().get(channel).type().bytes() * pixels();
    }

    int pixels() {
        return block.width() * block.height();
    }

    int blocksAcross() {
        return Math.ceilDiv(block.width(), SIDE);
    }

    int blocksDown() {
        return Math.ceilDiv(block.height(), SIDE);
    }

    /** Returns the blocks of cosines of all channels. */
    int blockCount() {
        return sets.stream().mapToInt(set -> set.length).sum() * blocksAcross() * blocksDown();
    }
}
