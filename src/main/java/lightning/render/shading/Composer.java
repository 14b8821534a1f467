package lightning.render.shading;

import java.util.Arrays;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.scene.World;
import lightning.scene.effects.ViewEffects;

/**
 * The third stage for one tile and level: sums the lights' contributions and closes the equation
 * over all rows. Holds scratch columns: one for each thread.
 */
final class Composer {
    private static final int ROWS = Terms.ROWS;

    private final boolean litTextures;
    private final Sums sums;
    private final LightSum lightSum;
    private final Shade[] shades;
    /** Made when it is needed first. */
    private ClearSums clear;
    private final float[][] colors = new float[3][ROWS];
    /** Stands for a sum that is left out. */
    private final float[][] none = new float[3][ROWS];
    private LightPart part = LightPart.ALL;

    Composer(MaterialTable materials, Sums sums, ViewEffects view) {
        this.sums = sums;
        lightSum = new LightSum(sums);
        shades = new Shade[materials.count()];
        Arrays.setAll(shades, m -> Shade.of(materials, m));
        litTextures = view.litTextures();
    }

    LightSum lightSum() {
        return lightSum;
    }

    /** Which contributions are composed from now on. */
    void setPart(LightPart v) {
        part = v;
    }

    /**
     * Writes the colour of each row to its parent.
     *
     * @param lights   the lights in scene order
     * @param layers   the layer of each light; unread where the light is dark
     * @param branches sums that are known already, or null
     * @param images   what the rays bring that go on from the rows; null where none does
     * @param to       gets the colours, linear: red, green, blue, {@code float[1024]} each
     */
    void compose(HitRows rows, Luminaire[] lights, LightLayer[] layers, BranchSums branches, World world, Images images,
            float[][] to) {
        SumRows sum = branches == null ? lightSum.of(rows.count, lights, layers) : lightSum.of(rows.count, lights, layers, branches);
        float ambience = (float) world.ambience();
        // Rows of one material keep the order of their parents: where every place has its row, row i goes to place i.
        boolean inOrder = rows.runs == 1 && rows.count == ROWS;
        for (int r = 0; r < rows.runs; r++) {
            close(rows, r, sum, ambience, images, inOrder ? to : colors);
            if (!inOrder) {
                scatter(rows.parent, rows.runStart(r), rows.runEnd[r], to);
            }
        }
    }

    private void close(HitRows rows, int run, SumRows sum, float ambience, Images images, float[][] to) {
        Shade shade = shades[rows.runMaterial[run]];
        if (shade.pictured() && !litTextures) {
            emit(rows, run, shade, ambience, to);
            return;
        }
        boolean shines = part != LightPart.DIFFUSE;
        float[][] diffuse = part == LightPart.SPECULAR ? none : sum.diffuse;
        float[][] specular = shines && sum.hasSpecular && shade.shines() ? sum.specular : null;
        float[][] grazing = shines && sum.hasGrazing && shade.metal() != null ? sum.grazing : null;
        if (shade.clarity() != null) {
            clear = clear == null ? new ClearSums() : clear;
            clear.close(rows, run, shade, ambience, diffuse, specular, grazing, images, to);
        } else {
            sums.close(rows, run, shade, ambience, diffuse, specular, grazing, images == null ? null : images.mirrored(), to);
        }
    }

    /** A texture that shows its own colour, whatever the lights. */
    private static void emit(HitRows rows, int run, Shade shade, float ambience, float[][] to) {
        for (int c = 0; c < 3; c++) {
            float[] texel = rows.texel(c);
            for (int i = rows.runStart(run); i < rows.runEnd[run]; i++) {
                to[c][i] = shade.ambient()[c] * ambience + shade.diffuse()[c] * texel[i];
            }
        }
    }

    /** Writes the colours of a run's rows to their parents, as many at once as have parents side by side. */
    private void scatter(short[] parent, int start, int end, float[][] to) {
        for (int i = start; i < end;) {
            int first = parent[i];
            int next = i + 1;
            while (next < end && parent[next] - first == next - i) {
                next++;
            }
            for (int c = 0; c < 3; c++) {
                System.arraycopy(colors[c], i, to[c], first, next - i);
            }
            i = next;
        }
    }
}
