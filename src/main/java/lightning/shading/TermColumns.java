package lightning.shading;

import java.util.Arrays;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorSpecies;
import lightning.effects.Effect;
import lightning.effects.ViewEffects;
import lightning.trace.HitRows;
import lightning.trace.MaterialTable;
import lightning.trace.RayPacket;

/**
 * Writes the columns of a layer from lanes that were aimed at the light: 0 for rows that are not lit.
 * Holds scratch memory: one for each thread.
 */
final class TermColumns {
    private static final VectorSpecies<Float> F = FloatVector.SPECIES_PREFERRED;

    private final MaterialTable materials;
    private final LightLanes lanes;
    private final float[] specular = new float[LightLanes.ROWS];
    private final boolean everySpecular;
    private final boolean everyFalloff;

    /** @param view whether columns are written that hold nothing but what changes no picture */
    TermColumns(MaterialTable materials, LightLanes lanes, ViewEffects view) {
        everySpecular = view.forces(Effect.SPECULAR);
        everyFalloff = view.forces(Effect.ATTENUATION) || view.forces(Effect.DROPOFF);
        this.materials = materials;
        this.lanes = lanes;
    }

    /** The cosine of lit rows. */
    float[] cosines(HitRows rows, float[] cosine, int[] lit, Columns columns) {
        float[] column = columns.floats(rows.count);
        for (int b = 0, i = 0; i < rows.count; b++, i += F.length()) {
            FloatVector c = FloatVector.fromArray(F, cosine, i);
            FloatVector.zero(F).blend(c, VectorMask.fromLong(F, lit[b])).intoArray(column, i);
        }
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
        return everySpecular || materials.isSpecular(material);
    }

    private void run(HitRows rows, int r, int[] lit, int[] known, float[] before, float[] column) {
        int from = rows.runStart(r);
        int to = rows.runEnd[r];
        int first = to;
        int last = from;
        for (int b = from / F.length(); b * F.length() < to; b++) {
            int in = lit[b] & within(b, from, to);
            int fresh = known == null ? in : in & ~known[b];
            if (fresh != in) {
                merge(before, column, b, in & ~fresh);
            }
            if (fresh != 0) {
                first = Math.min(first, b * F.length());
                last = (b + 1) * F.length();
            }
        }
        if (first >= last) {
            return;
        }
        lanes.speculars(rows, first, last, materials.shininess(rows.runMaterial[r]), specular);
        for (int b = first / F.length(); b * F.length() < last; b++) {
            int in = lit[b] & within(b, from, to);
            merge(specular, column, b, known == null ? in : in & ~known[b]);
        }
    }

    /** The bits of word {@code b} that stand for rows {@code from … to}. */
    private static int within(int b, int from, int to) {
        int start = Math.max(0, from - b * RayPacket.WIDTH);
        return RowBits.valid(b, to) & -1 << start;
    }

    private static void merge(float[] from, float[] to, int b, int bits) {
        if (bits != 0) {
            int i = b * F.length();
            FloatVector old = FloatVector.fromArray(F, to, i);
            old.blend(FloatVector.fromArray(F, from, i), VectorMask.fromLong(F, bits)).intoArray(to, i);
        }
    }

    /** The falloff of all rows, lit or not; null where it is 1 everywhere. */
    float[] falloffs(HitRows rows, Lamp lamp, Columns columns) {
        if (!lamp.fallsOff() && !(everyFalloff && lamp.type().hasPosition())) {
            return null;
        }
        float[] column = columns.floats(rows.count);
        lanes.falloffs(rows, lamp, column);
        return column;
    }
}
