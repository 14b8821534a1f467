package lightning.render.shading;

import java.util.Arrays;
import lightning.render.trace.BounceKind;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SamplePositions;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.effects.ViewEffects;

/**
 * Carries colors from the deepest mirror level of a tile up to its pixels. Holds scratch columns:
 * one for each thread.
 */
public final class TileComposer {
    private final LevelComposer composer;
    private final BackgroundShader backgroundShader = new BackgroundShader();
    private final MaterialTable materials;
    /** By the depth of a level. */
    private BounceImages[] scratch = new BounceImages[2];

    public TileComposer(MaterialTable materials, SumKernel sums, ViewEffects view) {
        this.materials = materials;
        composer = new LevelComposer(materials, sums, view);
    }

    /**
     * What the rays bring that go on from a level's rows, where they are not followed: the recursion ended there.
     *
     * @param depth over how many others the level is seen
     * @return valid until this is asked again for the same depth; null where no ray goes on
     */
    public BounceImages blackImages(HitRows rows, int depth) {
        BounceImages images = scratchImages(rows, depth);
        for (BounceKind bounce : BounceKind.values()) {
            for (int c = 0; c < 3 && bounce.rowCount(rows) > 0; c++) {
                Arrays.fill(images.forBounce(bounce)[c], 0, bounce.rowCount(rows), 0);
            }
        }
        return images;
    }

    /**
     * Where the colors go that the rays bring which go on from a level's rows, to be composed from the levels below: the background
     * where a ray hit nothing.
     *
     * @param depth over how many others the level is seen
     * @return valid until this is asked again for the same depth; null where no ray goes on
     */
    public BounceImages backgroundImages(HitRows rows, World world, int depth) {
        BounceImages images = scratchImages(rows, depth);
        for (BounceKind bounce : BounceKind.values()) {
            if (bounce.rowCount(rows) > 0) {
                backgroundShader.shadeBounceRays(rows, bounce, materials, world, images.forBounce(bounce));
            }
        }
        return images;
    }

    private BounceImages scratchImages(HitRows rows, int depth) {
        if (rows.reflectiveCount == 0) {
            return null;
        }
        if (depth >= scratch.length) {
            scratch = Arrays.copyOf(scratch, depth + 1);
        }
        if (scratch[depth] == null || rows.transparentCount > 0 && scratch[depth].refracted() == null) {
            scratch[depth] = new BounceImages(new float[3][TermKernel.MAX_ROWS],
                    rows.transparentCount > 0 ? new float[3][TermKernel.MAX_ROWS] : null);
        }
        return scratch[depth];
    }

    /** Makes a tile of the film ready for the colors of a first level: what is behind all where no row is. */
    public void fillBackground(HitRows rows, Scene scene, SamplePositions places, float[][] film) {
        backgroundShader.shadeEyeRays(rows, scene, places, film);
    }

    /**
     * Composes the rows of one level.
     *
     * @param lights   the lights in scene order
     * @param layers   the layer of each light; unread where the light is dark
     * @param branches sums that are known already, or null
     * @param images   what the rays bring that go on from the rows; null where none does
     * @param to       gets each row's color at its parent, linear: red, green, blue, {@code float[1024]} each
     */
    public void composeLevel(HitRows rows, WeightedLight[] lights, LightLayer[] layers, BranchSums branches, World world,
            BounceImages images,
            float[][] to) {
        composer.compose(rows, lights, layers, branches, world, images, to);
    }

    /** Which of the lights' contributions levels are composed of from now on: all of them until it is called. */
    public void setComponent(LightComponent part) {
        composer.setComponent(part);
    }

    /** The sums beside one light, to be given to {@link #composeLevel} while that light alone is edited. */
    public BranchSums branchSums(HitRows rows, WeightedLight[] lights, LightLayer[] layers, BranchSums.Key key) {
        return composer.lightSum().branchSums(rows.count, lights, layers, key);
    }
}
