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
    private final int[] kept = RowBits.room();
    private final int[] fresh = RowBits.room();
    private final double[] factors = new double[Terms.ROWS];

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
        int[] asked = lit;
        if (known == null) {
            Arrays.fill(column, 0, rows.count, 0);
        } else {
            asked = fresh;
            for (int b = 0; b < RowBits.words(rows.count); b++) {
                kept[b] = lit[b] & known[b];
                fresh[b] = lit[b] & ~known[b];
            }
            terms.select(before, kept, rows.count, column);
        }
        speculars(rows, asked, column);
        return column;
    }

    /** Writes the specular term of those rows of a set whose material has one. */
    void speculars(HitRows rows, int[] asked, float[] column) {
        for (int r = 0; r < rows.runs; r++) {
            int material = rows.runMaterial[r];
            if (isSpecular(material)) {
                terms.speculars(rows, rows.runStart(r), rows.runEnd[r], asked, materials.shininess(material), column);
            }
        }
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

    /** The falloff of all rows, lit or not; null where it is 1 everywhere. */
    float[] falloffs(HitRows rows, Lamp lamp, Columns columns) {
        if (!demands.fallsOff(lamp)) {
            return null;
        }
        float[] column = columns.floats(rows.count);
        Shaping doors = Shaping.of(lamp);
        if (doors == null) {
            terms.falloffs(rows, lamp, column);
        } else {
            terms.factors(rows, lamp, factors);
            doors.multiply(rows, factors);
            for (int i = 0; i < rows.count; i++) {
                column[i] = (float) factors[i];
            }
        }
        return column;
    }
}
