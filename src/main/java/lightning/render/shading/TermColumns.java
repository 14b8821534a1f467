package lightning.render.shading;

import java.util.Arrays;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;

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

    /** The diffuse term of lit rows, which is their cosine but for metallic materials. */
    float[] diffuses(HitRows rows, float[] cosine, int[] lit, Columns columns) {
        float[] column = columns.floats(rows.count);
        terms.select(cosine, lit, rows.count, column);
        mattes(rows, lit, column);
        return column;
    }

    /** Writes the diffuse term of those rows of a set whose material is metallic in place of their cosine. */
    void mattes(HitRows rows, int[] asked, float[] column) {
        for (int r = 0; r < rows.runs; r++) {
            if (materials.isMetallic(rows.runMaterial[r])) {
                terms.mattes(rows, rows.runStart(r), rows.runEnd[r], asked, column);
            }
        }
    }

    /** The terms beside the diffuse one, each null where no material has it. */
    record Speculars(float[] specular, float[] grazing) {
        static final Speculars NONE = new Speculars(null, null);

        /** Those of a layer; none where there is no layer. */
        static Speculars of(LightRows layer) {
            return layer == null ? NONE : new Speculars(layer.specular, layer.grazing);
        }
    }

    /**
     * The specular and grazing terms of lit rows.
     *
     * @param known rows whose terms stand in {@code before}, as far as it has these columns; null for none
     */
    Speculars speculars(HitRows rows, int[] lit, int[] known, Speculars before, Columns columns) {
        if (!hasSpecular(rows)) {
            return Speculars.NONE;
        }
        boolean metallic = hasMetallic(rows);
        int[] asked = lit;
        if (known != null) {
            asked = fresh;
            for (int b = 0; b < RowBits.words(rows.count); b++) {
                kept[b] = lit[b] & known[b];
                fresh[b] = lit[b] & ~known[b];
            }
        }
        float[] column = begun(rows, known, before.specular, columns);
        float[] grazing = metallic ? begun(rows, known, before.grazing, columns) : null;
        speculars(rows, asked, column, grazing);
        return new Speculars(column, grazing);
    }

    /** A column with the terms of the rows in {@link #kept}, and 0 elsewhere. */
    private float[] begun(HitRows rows, int[] known, float[] before, Columns columns) {
        float[] column = columns.floats(rows.count);
        if (known == null || before == null) {
            Arrays.fill(column, 0, rows.count, 0);
        } else {
            terms.select(before, kept, rows.count, column);
        }
        return column;
    }

    /**
     * Writes the specular term of those rows of a set whose material has one.
     *
     * @param grazing gets the grazing term of those whose material is metallic; unread where none is
     */
    void speculars(HitRows rows, int[] asked, float[] column, float[] grazing) {
        for (int r = 0; r < rows.runs; r++) {
            int material = rows.runMaterial[r];
            if (materials.isMetallic(material)) {
                terms.glosses(rows, rows.runStart(r), rows.runEnd[r], asked, materials.alpha(material), column, grazing);
            } else if (isSpecular(material)) {
                terms.speculars(rows, rows.runStart(r), rows.runEnd[r], asked, materials.shininess(material), column);
            }
        }
    }

    /** Adds the rows to a set that may have a specular term of any sample of a light. */
    void mayShine(HitRows rows, Lamp lamp, int[] may) {
        for (int r = 0; r < rows.runs; r++) {
            int material = rows.runMaterial[r];
            if (materials.isMetallic(material)) {
                RowBits.add(may, rows.runStart(r), rows.runEnd[r]);
            } else if (isSpecular(material)) {
                terms.mayShine(rows, rows.runStart(r), rows.runEnd[r], lamp, materials.shininess(material), may);
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

    /** Whether any of the rows' materials is metallic. */
    boolean hasMetallic(HitRows rows) {
        for (int r = 0; r < rows.runs; r++) {
            if (materials.isMetallic(rows.runMaterial[r])) {
                return true;
            }
        }
        return false;
    }

    boolean isMetallic(int material) {
        return materials.isMetallic(material);
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
