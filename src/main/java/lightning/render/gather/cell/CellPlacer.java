package lightning.render.gather.cell;

import java.util.Arrays;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;

/**
 * Chooses points among candidates: one in each cell that is not divided. Where other surfaces are near, seen from the point, the cell is divided, as an
 * irradiance cache does (G. Ward and others, A ray tracing solution for diffuse interreflection, 1988).
 */
public abstract class CellPlacer {
    /** Points that a thread works at together. */
    protected static final int BATCH = 4096;
    /** Number of no point. */
    protected static final int NONE = -1;
    /** Radius of a point in sides of its cell. */
    protected static final float RADIUS = 1.2f;
    /** Largest radius relative to the harmonic mean distance of the surfaces around. */
    protected static final float ACCURACY = 0.2f;

    /** Returns the cell of a candidate. */
    protected abstract long cell(int candidate, int level);

    /** Adds a point at a candidate, and returns its number. */
    protected abstract int add(int candidate, int level);

    /** Prepares the points that a level added, from {@code first} on. */
    protected abstract void added(int first, int level);

    /** Sets the radius of a cell's point; returns whether the cell must be divided. Its point then belongs to one of the parts. */
    protected abstract boolean divide(int point, int level);

    /** Returns the number of points. */
    protected abstract int count();

    /** Chooses points among {@code candidates} candidates, in cells of up to {@code levels} sizes. */
    protected final void place(int candidates, int levels, WorkerPool workers, Progress progress) {
        int[] active = new int[candidates];
        Arrays.setAll(active, i -> i);
        long[] cell = new long[candidates];
        int[] point = new int[candidates];
        Arrays.fill(point, NONE);
        for (int level = 0; level < levels && active.length > 0; level++) {
            CellTable cells = new CellTable();
            int[] chosen = choose(active, cell, level, cells, workers, progress);
            int first = count();
            for (int candidate : chosen) {
                // The first candidate of a cell is also the first of one of its parts.
                point[candidate] = point[candidate] == NONE ? add(candidate, level) : point[candidate];
            }
            added(first, level);
            for (int candidate : chosen) {
                cells.setNumber(cell[candidate], divide(point[candidate], level) ? 1 : 0);
            }
            active = Arrays.stream(active).filter(candidate -> cells.number(cell[candidate]) == 1).toArray();
        }
    }

    /** Returns the first candidate in each cell of a level; writes the cells of the candidates. */
    private int[] choose(int[] active, long[] cell, int level, CellTable cells, WorkerPool workers, Progress progress) {
        workers.run(Math.ceilDiv(active.length, BATCH), (_, job) -> {
            for (int i = job * BATCH; i < Math.min(active.length, job * BATCH + BATCH); i++) {
                int k = active[i];
                cell[k] = cell(k, level);
                cells.add(cell[k], k);
            }
        }, progress);
        return cells.firsts();
    }
}
