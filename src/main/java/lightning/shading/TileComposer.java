package lightning.shading;

import java.util.Arrays;
import lightning.effects.ViewEffects;
import lightning.math.Rgb;
import lightning.scene.World;
import lightning.trace.HitRows;
import lightning.trace.MaterialTable;

/**
 * Carries colours from the deepest mirror level of a tile up to its pixels. Holds scratch columns:
 * one for each thread.
 */
public final class TileComposer {
    private final Composer composer;
    private final float[][] mirrored = new float[3][Terms.ROWS];

    public TileComposer(MaterialTable materials, Sums sums, ViewEffects view) {
        composer = new Composer(materials, sums, view);
    }

    /**
     * Cr of the reflective rows of a level whose rays were not followed: the recursion ended there.
     *
     * @return red, green and blue columns, valid until the next call
     */
    public float[][] unfollowed(HitRows rows) {
        for (float[] channel : mirrored) {
            Arrays.fill(channel, 0, rows.reflective, 0);
        }
        return mirrored;
    }

    /**
     * Cr of the reflective rows of a level from the colours of the level below, which was composed
     * last: the background where a ray hit nothing.
     *
     * @return red, green and blue columns, valid until the next call
     */
    public float[][] followed(HitRows rows, HitRows below, World world) {
        fill(mirrored, rows.reflective, world.background());
        scatter(below, mirrored[0], mirrored[1], mirrored[2]);
        return mirrored;
    }

    /**
     * Composes the rows of one level.
     *
     * @param lights   the lights in scene order
     * @param layers   the layer of each light; unread where the light is dark
     * @param branches sums that are known already, or null
     * @param cr       Cr of the reflective rows: red, green and blue columns; null where there are none
     */
    public void level(HitRows rows, Luminaire[] lights, LightLayer[] layers, BranchSums branches, World world, float[][] cr) {
        composer.compose(rows, lights, layers, branches, world, cr);
    }

    /** The sums beside one light, to be given to {@link #level} while that light alone is edited. */
    public BranchSums branches(HitRows rows, Luminaire[] lights, LightLayer[] layers, BranchSums.Key key) {
        return composer.lightSum().branches(rows.count, lights, layers, key);
    }

    /** Writes the colours composed last to a tile of the film: the background where no row is. */
    public void toFilm(HitRows rows, World world, float[] red, float[] green, float[] blue) {
        if (rows.count < red.length) {
            fill(new float[][] {red, green, blue}, red.length, world.background());
        }
        scatter(rows, red, green, blue);
    }

    private static void fill(float[][] columns, int length, Rgb color) {
        Arrays.fill(columns[0], 0, length, (float) color.r());
        Arrays.fill(columns[1], 0, length, (float) color.g());
        Arrays.fill(columns[2], 0, length, (float) color.b());
    }

    /** Writes each row's colour to its parent. */
    private void scatter(HitRows rows, float[] red, float[] green, float[] blue) {
        short[] parent = rows.parent;
        // Rows of one material keep the order of their parents: where every parent has its row, row i is parent i.
        if (rows.runs == 1 && parent[rows.count - 1] == rows.count - 1) {
            System.arraycopy(composer.red(), 0, red, 0, rows.count);
            System.arraycopy(composer.green(), 0, green, 0, rows.count);
            System.arraycopy(composer.blue(), 0, blue, 0, rows.count);
            return;
        }
        scatter(rows.count, parent, composer.red(), red);
        scatter(rows.count, parent, composer.green(), green);
        scatter(rows.count, parent, composer.blue(), blue);
    }

    private static void scatter(int count, short[] parent, float[] from, float[] to) {
        for (int i = 0; i < count; i++) {
            to[parent[i]] = from[i];
        }
    }
}
