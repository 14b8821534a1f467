package lightning.shading;

import java.util.Arrays;
import lightning.trace.HitRows;
import lightning.trace.MaterialTable;

/**
 * Writes the columns of a layer from terms that were aimed at the light: 0 for rows that are not lit.
 * Holds scratch memory: one for each thread.
 */
final class TermColumns {
    private final MaterialTable materials;
    private final Terms terms;
    private final Demands demands;
    private final int[] fresh = RowBits.room();

    TermColumns(MaterialTable materials, Terms terms, Demands demands) {
        this.materials = materials;
        this.terms = terms;
        this.demands = demands;
    }

    /** The cosine of lit rows. */
    float[] cosines(HitRows rows, float[] cosine, int[] lit, Columns columns) {
        float[] column = columns.floats(rows.count);
        terms.select(cosine, lit, rows.count, column);
        return column;
    }

    /**
     * The specular term of lit rows, or null where no material has one.
     *
     * @param known rows whose term stands in {@code before}; null for none
     */
    float[] speculars(HitRows rows, int[] lit, int[] known, float[] before, Columns columns) {
        if (!hasSpecular(rows)) {
            return null;
        }
        float[] column = columns.floats(rows.count);
        Arrays.fill(column, 0, rows.count, 0);
        for (int r = 0; r < rows.runs; r++) {
            if (isSpecular(rows.runMaterial[r])) {
                run(rows, r, lit, known, before, column);
            }
        }
        return column;
    }

    /** Whether any of the rows' materials has a specular term. */
    boolean hasSpecular(HitRows rows) {
        for (int r = 0; r < rows.runs; r++) {
            if (isSpecular(rows.runMaterial[r])) {
                return true;
            }
        }
        return false;
    }

    boolean isSpecular(int material) {
        return demands.isSpecular(materials, material);
    }

    private void run(HitRows rows, int r, int[] lit, int[] known, float[] before, float[] column) {
        int from = rows.runStart(r);
        int to = rows.runEnd[r];
        int[] asked = lit;
        if (known != null) {
            for (int i = from; i < to; i++) {
                if (RowBits.contains(known, i) && RowBits.contains(lit, i)) {
                    column[i] = before[i];
                }
            }
            for (int b = from / RowBits.WIDTH; b * RowBits.WIDTH < to; b++) {
                fresh[b] = lit[b] & ~known[b];
            }
            asked = fresh;
        }
        terms.speculars(rows, from, to, asked, materials.shininess(rows.runMaterial[r]), column);
    }

    /** The falloff of all rows, lit or not; null where it is 1 everywhere. */
    float[] falloffs(HitRows rows, Lamp lamp, Columns columns) {
        if (!demands.fallsOff(lamp)) {
            return null;
        }
        float[] column = columns.floats(rows.count);
        terms.falloffs(rows, lamp, column);
        return column;
    }
}
