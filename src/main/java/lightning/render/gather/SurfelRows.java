package lightning.render.gather;

import java.io.IOException;
import java.util.Arrays;
import java.util.BitSet;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.trace.HitRows;

/**
 * Rows of surfels in blocks of at most 1024.
 *
 * @param blocks  rows; {@code parent} is an index of the block's numbers
 * @param numbers surfel of each parent in each block
 * @param near    surfels whose cells are small
 * @param count   number of surfels
 */
public record SurfelRows(HitRows[] blocks, int[][] numbers, BitSet near, int count) {
    // Arrays in a record: written once by their creator, never after.

    void writeTo(ColumnWriter out) throws IOException {
        out.writeInt(count);
        out.writeArray(near.toByteArray());
        out.writeInt(blocks.length);
        for (int b = 0; b < blocks.length; b++) {
            blocks[b].writeTo(out);
            out.writeArray(numbers[b]);
        }
    }

    static SurfelRows readFrom(ColumnReader in) throws IOException {
        int count = in.readInt();
        BitSet near = BitSet.valueOf(in.readBytes());
        HitRows[] blocks = new HitRows[in.readCount()];
        int[][] numbers = new int[blocks.length][];
        for (int b = 0; b < blocks.length; b++) {
            blocks[b] = HitRows.readFrom(in);
            numbers[b] = in.readInts();
        }
        return new SurfelRows(blocks, numbers, near, count);
    }

    long bytes() {
        return Arrays.stream(blocks).mapToLong(HitRows::bytes).sum() + Arrays.stream(numbers).mapToLong(number -> 4L * number.length).sum()
                + count / 8;
    }
}
