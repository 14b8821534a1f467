package lightning.render.gather;

import java.util.Arrays;
import java.util.BitSet;
import lightning.render.trace.HitRows;

/**
 * Rows of surfels in blocks of at most 1024.
 *
 * @param blocks  rows; {@code parent} is an index of the block's numbers
 * @param numbers surfel of each parent in each block
 * @param near    surfels whose cells are small
 * @param count   number of surfels
 */
record SurfelRows(HitRows[] blocks, int[][] numbers, BitSet near, int count) {
    // Arrays in a record: written once by their creator, never after.

    long bytes() {
        return Arrays.stream(blocks).mapToLong(HitRows::bytes).sum() + Arrays.stream(numbers).mapToLong(number -> 4L * number.length).sum()
                + count / 8;
    }
}
