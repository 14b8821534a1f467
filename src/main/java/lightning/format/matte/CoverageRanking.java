package lightning.format.matte;

import java.util.Arrays;

/**
 * Ids that the samples of one pixel hit, by descending number of samples; the id of the first sample is first among equals. Used
 * for one pixel after the other: holds scratch memory.
 */
public final class CoverageRanking {
    private int[] bits = new int[8];
    private int[] counts = new int[8];
    private int size;

    /** Removes all ids. */
    public void clear() {
        size = 0;
    }

    /** Adds a sample. */
    public void add(int idBits) {
        int i = 0;
        while (i < size && bits[i] != idBits) {
            i++;
        }
        if (i == size) {
            if (size == bits.length) {
                bits = Arrays.copyOf(bits, 2 * size);
                counts = Arrays.copyOf(counts, 2 * size);
            }
            bits[size] = idBits;
            counts[size++] = 0;
        }
        counts[i]++;
    }

    /** Returns the number of ids. */
    public int size() {
        return size;
    }

    /**
     * Writes ids and coverages by rank: id 0, coverage 0, id 1 and so on; zeros after the last.
     *
     * @param samples samples of the pixel, with those that hit nothing
     * @param out two values for each rank
     */
    public void write(int samples, float[] out) {
        Arrays.fill(out, 0);
        for (int i = 1; i < size; i++) {
            int id = bits[i];
            int count = counts[i];
            int k = i;
            for (; k > 0 && counts[k - 1] < count; k--) {
                bits[k] = bits[k - 1];
                counts[k] = counts[k - 1];
            }
            bits[k] = id;
            counts[k] = count;
        }
        for (int rank = 0; rank < Math.min(size, out.length / 2); rank++) {
            out[2 * rank] = Float.intBitsToFloat(bits[rank]);
            out[2 * rank + 1] = (float) counts[rank] / samples;
        }
    }
}
