package lightning.render.trace;

import java.util.BitSet;
import java.util.stream.IntStream;
import lightning.scene.Scene;

/**
 * Cells of a pixel's grid that have a sample at their centers: all, the first ones, or the rest. The first samples decide whether
 * the rest is needed.
 *
 * @param grid  cells along each side of a pixel
 * @param cells indices of the cells, line by line, ascending
 */
public record SampleCells(int grid, int[] cells) {
    // An array in a record: written once by its creator.

    /** Number of first samples: one in each quarter of the pixel, and no two in a line or column (a rotated grid). */
    private static final int FIRST_COUNT = 4;
    /** The column, in quarters of the pixel, of the first sample in each quarter of the lines. */
    private static final int[] FIRST_COLUMNS = {1, 3, 0, 2};

    /** Returns all cells. */
    public static SampleCells all(int grid) {
        return new SampleCells(grid, IntStream.range(0, grid * grid).toArray());
    }

    /** Returns the cells that every pixel with several samples has. */
    public static SampleCells first(Scene scene) {
        int grid = scene.picture().sampling().grid();
        return scene.hasSamplesOnlyAtEdges() ? first(grid) : all(grid);
    }

    /** Returns the cells that a pixel also has if its first samples differ much; none if the first are all. */
    public static SampleCells rest(Scene scene) {
        int grid = scene.picture().sampling().grid();
        return scene.hasSamplesOnlyAtEdges() ? rest(grid) : new SampleCells(grid, new int[0]);
    }

    /** Returns the cells of the first samples; all cells of a grid that cannot be refined. */
    public static SampleCells first(int grid) {
        return grid >= FIRST_COUNT
                ? new SampleCells(grid,
                        IntStream.range(0, FIRST_COUNT).map(i -> quarter(i, grid) * grid + quarter(FIRST_COLUMNS[i], grid)).toArray())
                : all(grid);
    }

    /** Returns the cells that are not among the first; none of a grid that cannot be refined. */
    public static SampleCells rest(int grid) {
        BitSet first = new BitSet();
        for (int cell : first(grid).cells) {
            first.set(cell);
        }
        return new SampleCells(grid, IntStream.range(0, grid * grid).filter(cell -> !first.get(cell)).toArray());
    }

    /** Returns the cell in the middle of a quarter of a side. */
    private static int quarter(int i, int grid) {
        return (2 * i + 1) * grid / (2 * FIRST_COUNT);
    }

    /** Returns the number of samples. */
    public int count() {
        return cells.length;
    }

    /** Returns the part of an area light's samples that sample {@code s} uses. */
    public int part(int s) {
        return parts(grid)[cells[s]];
    }

    /**
     * Returns the part of an area light's samples that each cell of a grid uses: those of the first cells are evenly spaced, so
     * that few samples cover the light, too.
     */
    static int[] parts(int grid) {
        int[] first = first(grid).cells;
        int[] parts = new int[grid * grid];
        BitSet used = new BitSet();
        for (int i = 0; i < first.length; i++) {
            parts[first[i]] = i * parts.length / first.length;
            used.set(parts[first[i]]);
        }
        for (int cell : rest(grid).cells) {
            parts[cell] = used.nextClearBit(0);
            used.set(parts[cell]);
        }
        return parts;
    }
}
