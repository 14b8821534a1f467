package lightning.render.shading;

import java.util.Arrays;
import lightning.render.trace.Bounce;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SamplePlaces;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.effects.ViewEffects;

/**
 * Carries colours from the deepest mirror level of a tile up to its pixels. Holds scratch columns:
 * one for each thread.
 */
public final class TileComposer {
    private final Composer composer;
    private final Backdrop backdrop = new Backdrop();
    private final MaterialTable materials;
    /** By the depth of a level. */
    private Images[] scratch = new Images[2];

    public TileComposer(MaterialTable materials, Sums sums, ViewEffects view) {
        this.materials = materials;
        composer = new Composer(materials, sums, view);
    }

    /**
     * What the rays bring that go on from a level's rows, where they are not followed: the recursion ended there.
     *
     * @param depth over how many others the level is seen
     * @return valid until this is asked again for the same depth; null where no ray goes on
     */
    public Images unfollowed(HitRows rows, int depth) {
        Images images = images(rows, depth);
        for (Bounce bounce : Bounce.values()) {
            for (int c = 0; c < 3 && bounce.rows(rows) > 0; c++) {
                Arrays.fill(images.of(bounce)[c], 0, bounce.rows(rows), 0);
            }
        }
        return images;
    }

    /**
     * Where the colours go that the rays bring which go on from a level's rows, to be composed from the levels below: the background
     * where a ray hit nothing.
     *
     * @param depth over how many others the level is seen
     * @return valid until this is asked again for the same depth; null where no ray goes on
     */
    public Images followed(HitRows rows, World world, int depth) {
        Images images = images(rows, depth);
        for (Bounce bounce : Bounce.values()) {
            if (bounce.rows(rows) > 0) {
                backdrop.behind(rows, bounce, materials, world, images.of(bounce));
            }
        }
        return images;
    }

    private Images images(HitRows rows, int depth) {
        if (rows.reflective == 0) {
            return null;
        }
        if (depth >= scratch.length) {
            scratch = Arrays.copyOf(scratch, depth + 1);
        }
        if (scratch[depth] == null || rows.clear > 0 && scratch[depth].refracted() == null) {
            scratch[depth] = new Images(new float[3][Terms.ROWS], rows.clear > 0 ? new float[3][Terms.ROWS] : null);
        }
        return scratch[depth];
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
     * @param images   what the rays bring that go on from the rows; null where none does
     * @param to       gets each row's colour at its parent, linear: red, green, blue, {@code float[1024]} each
     */
    public void level(HitRows rows, Luminaire[] lights, LightLayer[] layers, BranchSums branches, World world, Images images,
            float[][] to) {
        composer.compose(rows, lights, layers, branches, world, images, to);
    }

    /** Which of the lights' contributions levels are composed of from now on: all of them until it is called. */
    public void setPart(LightPart part) {
        composer.setPart(part);
    }

    /** The sums beside one light, to be given to {@link #level} while that light alone is edited. */
    public BranchSums branches(HitRows rows, Luminaire[] lights, LightLayer[] layers, BranchSums.Key key) {
        return composer.lightSum().branches(rows.count, lights, layers, key);
    }
}
