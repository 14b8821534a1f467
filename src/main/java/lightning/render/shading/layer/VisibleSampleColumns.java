package lightning.render.shading.layer;

import java.util.Arrays;
import lightning.render.trace.HitRows;
import org.jspecify.annotations.Nullable;

/**
 * Conversion of visible samples of an area light between columns, which hold a set of samples for each row, and {@link RowBits},
 * which hold a set of rows for each sample. Holds scratch memory: use one instance per thread.
 */
final class VisibleSampleColumns {
    /** Square of bits: as many samples and rows as a word and a column hold. */
    private final int[] square = new int[RowBits.WIDTH];

    /**
     * Reads the rows that see each sample.
     *
     * @param columns  null if no row sees any; samples beyond them are visible from no row
     * @param unblocked receives a set of rows for each sample
     */
    void read(HitRows rows, short @Nullable [][] columns, int samples, int[][] unblocked) {
        for (int first = 0; first < samples; first += LightRows.SAMPLES_PER_COLUMN) {
            short[] column = LightRows.sampleColumn(columns, first / LightRows.SAMPLES_PER_COLUMN);
            for (int b = 0; b < RowBits.words(rows.count); b++) {
                int row = b * RowBits.WIDTH;
                for (int i = row; i < row + RowBits.WIDTH; i++) {
                    square[i - row] = column != null && i < rows.count ? column[i] & 0xFFFF : 0;
                }
                RowBits.transpose(square);
                for (int s = first; s < Math.min(samples, first + LightRows.SAMPLES_PER_COLUMN); s++) {
                    unblocked[s][b] = square[s - first];
                }
            }
        }
    }

    /** Returns columns of the samples that each row sees. */
    short[][] write(HitRows rows, int[][] unblocked, int samples, ColumnAllocator allocator) {
        short[][] columns = new short[(samples - 1) / LightRows.SAMPLES_PER_COLUMN + 1][];
        for (int k = 0; k < columns.length; k++) {
            columns[k] = allocator.shorts(rows.count);
            int first = k * LightRows.SAMPLES_PER_COLUMN;
            int count = Math.min(LightRows.SAMPLES_PER_COLUMN, samples - first);
            for (int b = 0; b < RowBits.words(rows.count); b++) {
                for (int s = 0; s < LightRows.SAMPLES_PER_COLUMN; s++) {
                    square[s] = s < count ? unblocked[first + s][b] : 0;
                }
                RowBits.transpose(square);
                int row = b * RowBits.WIDTH;
                for (int i = row; i < Math.min(row + RowBits.WIDTH, rows.count); i++) {
                    columns[k][i] = (short) square[i - row];
                }
            }
        }
        return columns;
    }

    /** Returns whether all rows see the same samples in both; null means that no row sees any. */
    static boolean areEqual(HitRows rows, short @Nullable [][] a, short @Nullable [][] b) {
        boolean isEqual = a == null || b == null ? a == b : a.length == b.length;
        for (int k = 0; isEqual && a != null && b != null && k < a.length; k++) {
            isEqual = Arrays.equals(a[k], 0, rows.count, b[k], 0, rows.count);
        }
        return isEqual;
    }
}
