package lightning.shading;

import java.util.Arrays;
import lightning.effects.ViewEffects;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.trace.HitRows;
import lightning.trace.MaterialTable;
import lightning.trace.SamplePlaces;

/**
 * Carries colours from the deepest mirror level of a tile up to its pixels. Holds scratch columns:
 * one for each thread.
 */
public final class TileComposer {
    private final Composer composer;
    private final Backdrop backdrop = new Backdrop();
    /** Cr of one level, and of the level above it. */
    private final float[][][] mirrored = new float[2][3][Terms.ROWS];

    public TileComposer(MaterialTable materials, Sums sums, ViewEffects view) {
        composer = new Composer(materials, sums, view);
    }

    /**
     * Cr of the reflective rows of a level whose rays were not followed: the recursion ended there.
     *
     * @return red, green and blue columns, valid until the next level but one was composed
     */
    public float[][] unfollowed(HitRows rows) {
        for (float[] channel : next()) {
            Arrays.fill(channel, 0, rows.reflective, 0);
        }
        return mirrored[0];
    }

    /**
     * Where the colours that the reflective rows of a level mirror go, to be composed from the level below: the background
     * where a ray hit nothing.
     *
     * @return red, green and blue columns, valid until the next level but one was composed
     */
    public float[][] followed(HitRows rows, World world) {
        backdrop.mirrored(rows, world, next());
        return mirrored[0];
    }

    private float[][] next() {
        float[][] other = mirrored[1];
        mirrored[1] = mirrored[0];
        mirrored[0] = other;
        return other;
    }

    /** Makes a tile of the film ready for the colours of a first level: what is behind all where no row is. */
    public void background(HitRows rows, Scene scene, SamplePlaces places, float[][] film) {
        backdrop.eye(rows, scene, places, film);
    }

    /**
     * Composes the rows of one level.
     *
     * @param lights   the lights in scene order
     * @param layers   the layer of each light; unread where the light is dark
     * @param branches sums that are known already, or null
     * @param cr       Cr of the reflective rows: red, green and blue columns; null where there are none
     * @param to       gets each row's colour at its parent, linear: red, green, blue, {@code float[1024]} each
     */
    public void level(HitRows rows, Luminaire[] lights, LightLayer[] layers, BranchSums branches, World world, float[][] cr,
            float[][] to) {
        composer.compose(rows, lights, layers, branches, world, cr, to);
    }

    /** The sums beside one light, to be given to {@link #level} while that light alone is edited. */
    public BranchSums branches(HitRows rows, Luminaire[] lights, LightLayer[] layers, BranchSums.Key key) {
        return composer.lightSum().branches(rows.count, lights, layers, key);
    }
}
