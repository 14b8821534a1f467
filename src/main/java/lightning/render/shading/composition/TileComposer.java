package lightning.render.shading.composition;

import java.util.Arrays;
import lightning.render.shading.BackgroundShader;
import lightning.render.shading.BounceImages;
import lightning.render.shading.ClearTerms;
import lightning.render.shading.IndirectRows;
import lightning.render.shading.SumKernel;
import lightning.render.shading.TermKernel;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.LightLayer;
import lightning.render.trace.BounceKind;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SamplePositions;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/** Composes colors from the deepest level of a tile up to its pixels. Holds scratch columns: use one instance per thread. */
public final class TileComposer {
    private final LevelComposer composer;
    private final BackgroundShader backgroundShader;
    private final MaterialTable materials;
    /** Indexed by the depth of a level. */
    private BounceImages[] scratch = new BounceImages[2];

    /** @param scene scene whose camera and size tell how fine the environment is seen */
    public TileComposer(Scene scene, MaterialTable materials, SumKernel sums, ViewEffects view) {
        backgroundShader = new BackgroundShader(scene);
        this.materials = materials;
        composer = new LevelComposer(materials, sums, view);
    }

    /**
     * Returns black images for the rays that bounce from a level's rows if the recursion ended there; shared, and null if no ray
     * bounces.
     */
    public @Nullable BounceImages blackImages(HitRows rows) {
        return rows.reflectiveCount == 0 ? null : BounceImages.BLACK;
    }

    /**
     * Returns the images of the rays that bounce from a level's rows, to be composed from the levels below. They start with the
     * background, which remains if a ray hits nothing.
     *
     * @param depth number of levels above this one
     * @return valid until the next call for the same depth; null if no ray bounces
     */
    public @Nullable BounceImages backgroundImages(HitRows rows, World world, int depth) {
        BounceImages images = scratchImages(rows, depth);
        for (BounceKind bounce : BounceKind.values()) {
            if (images != null && bounce.rowCount(rows) > 0) {
                backgroundShader.shadeBounceRays(rows, bounce, materials, world, images.forBounce(bounce));
            }
        }
        return images;
    }

    private @Nullable BounceImages scratchImages(HitRows rows, int depth) {
        if (rows.reflectiveCount == 0) {
            return null;
        }
        if (depth >= scratch.length) {
            scratch = Arrays.copyOf(scratch, depth + 1);
        }
        if (scratch[depth] == null || rows.clearCount > 0 && scratch[depth].refracted() == null) {
            scratch[depth] = new BounceImages(new float[3][TermKernel.MAX_ROWS],
                    rows.clearCount > 0 ? new float[3][TermKernel.MAX_ROWS] : null);
        }
        return scratch[depth];
    }

    /** Fills the background of a tile before its first level is composed. */
    public void fillBackground(HitRows rows, Scene scene, SamplePositions places, float[][] film) {
        backgroundShader.shadeEyeRays(rows, scene, places, film);
    }

    /**
     * Composes the rows of one level.
     *
     * @param lights   lights in scene order
     * @param layers   layer of each light; unread if the light is dark
     * @param branches cached partial sums
     * @param terms    cached terms of clear rows
     * @param indirect indirect light of the rows
     * @param images   colors of the rays that bounce from the rows; null if there are none
     * @param to       receives each row's linear color at its parent: red, green, blue, {@code float[1024]} each
     */
    public void composeLevel(HitRows rows, WeightedLight[] lights, LightLayer[] layers, @Nullable BranchSums branches,
            @Nullable ClearTerms terms, World world, @Nullable IndirectRows indirect, @Nullable BounceImages images, float[][] to) {
        composer.compose(rows, lights, layers, branches, terms, world, indirect, images, to);
    }

    /** Composes the rows of one level without cached sums and terms. */
    public void composeLevel(HitRows rows, WeightedLight[] lights, LightLayer[] layers, World world, @Nullable IndirectRows indirect,
            @Nullable BounceImages images, float[][] to) {
        composeLevel(rows, lights, layers, null, null, world, indirect, images, to);
    }

    /** Composes the rows of one level without cached sums and terms, and without indirect light. */
    public void composeLevel(HitRows rows, WeightedLight[] lights, LightLayer[] layers, World world, @Nullable BounceImages images,
            float[][] to) {
        composeLevel(rows, lights, layers, world, null, images, to);
    }

    /** Returns the terms of a level's clear rows, for {@link #composeLevel}; null if its colors do not depend on them. */
    public @Nullable ClearTerms clearTerms(HitRows rows, @Nullable BounceImages images) {
        return composer.clearTerms(rows, images);
    }

    /** Returns whether terms of a level's clear rows fit the present materials. */
    public boolean isCurrent(ClearTerms terms, HitRows rows) {
        return composer.isCurrent(terms, rows);
    }

    /** Sets the light component that is composed from now on; initially all components. */
    public void setComponent(LightComponent part) {
        composer.setComponent(part);
    }

    /** Sets whether surfaces glow from now on; initially they do. */
    public void setShowsGlow(boolean v) {
        composer.setShowsGlow(v);
    }

    /** Returns the partial sums next to one light, for {@link #composeLevel} while only that light is edited. */
    public BranchSums branchSums(HitRows rows, WeightedLight[] lights, LightLayer[] layers, BranchSums.Key key) {
        return composer.lightSum().branchSums(rows.count, rows.owner, lights, layers, key);
    }
}
