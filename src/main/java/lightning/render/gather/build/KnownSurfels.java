package lightning.render.gather.build;

import static java.util.Objects.requireNonNull;

import lightning.render.gather.GatherStructure;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.trace.HitRows;
import lightning.render.trace.ShapeChange;

/**
 * Surfels before an edit, by number.
 *
 * @param places where they are; primitives have their new numbers, −1 for changed ones
 * @param keys   of the cells after the edit; of a part of a surfel, a key that is not its own
 */
record KnownSurfels(SurfaceColumns places, long[] keys) {
    // Arrays in a record: written once by the factory, never after.

    /** @param rows rows of the surfels, in the blocks of the structure */
    static KnownSurfels of(GatherStructure before, HitRows[] rows, ShapeChange shapes, CellKeys cells) {
        int count = before.surfelCount();
        SurfaceColumns places = new SurfaceColumns(count);
        places.count = count;
        KnownSurfels known = new KnownSurfels(places, new long[count]);
        for (int block = 0; block < rows.length; block++) {
            known.add(rows[block], before.numbers(block), before, shapes, cells);
        }
        return known;
    }

    private void add(HitRows rows, int[] numbers, GatherStructure before, ShapeChange shapes, CellKeys cells) {
        int[] primitives = shapes.mapIndices(requireNonNull(rows.owner));
        for (int row = 0; row < rows.count; row++) {
            int surfel = numbers[rows.parent[row]];
            places.set(surfel, rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row], rows.nz[row], primitives[row]);
            keys[surfel] = cells.surfelKey(rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row], rows.nz[row],
                    primitives[row], before.isNear(surfel));
        }
    }
}
