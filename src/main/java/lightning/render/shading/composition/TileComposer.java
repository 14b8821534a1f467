package lightning.render.shading.composition;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Set;
import lightning.render.shading.BackgroundShader;
import lightning.render.shading.BounceImages;
import lightning.render.shading.FilmParts;
import lightning.render.shading.IndirectRows;
import lightning.render.shading.SumKernel;
import lightning.render.shading.layer.LightLayer;
import lightning.render.trace.BounceKind;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SamplePositions;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/** Composes the levels of a tile for all films. Holds scratch memory: use one instance per thread. */
public final class TileComposer {
    private final LevelComposer composer;
    private final BackgroundShader backgroundShader;
    private final MaterialTable materials;
    private FilmColors[][] scratch = {};

    /** @param scene scene whose camera and size tell how fine the environment is seen */
    public TileComposer(Scene scene, MaterialTable materials, SumKernel sums, ViewEffects view) {
        this.materials = materials;
        backgroundShader = new BackgroundShader(scene);
        composer = new LevelComposer(materials, sums, view);
    }

    /**
     * Returns the colors of the rays that bounce from a level's rows, by {@link BounceKind}, to be composed from the levels below. They start
     * with the background, which remains if a ray hits nothing.
     *
     * @param films films that are composed
     * @param depth number of levels above this one
     * @return valid until the next call for the same depth
     */
    public FilmColors[] backgrounds(HitRows rows, FilmParts parts, BitSet films, int depth) {
        FilmColors[] images = images(depth);
        for (BounceKind bounce : BounceKind.values()) {
            FilmColors colors = images[bounce.ordinal()];
            colors.clear(parts.count(), bounce.rowCount(rows));
            if (bounce.rowCount(rows) > 0) {
                for (int part = films.nextSetBit(0); part >= 0; part = films.nextSetBit(part + 1)) {
                    if (backgroundShader.showsBackground(parts, part)) {
                        backgroundShader.shadeBounceRays(rows, bounce, materials, parts, part, colors.toWrite(part));
                    }
                }
            }
        }
        return images;
    }

    private FilmColors[] images(int depth) {
        if (depth >= scratch.length) {
            scratch = Arrays.copyOf(scratch, depth + 1);
        }
        FilmColors[] known = scratch[depth];
        if (known == null) {
            known = new FilmColors[] {new FilmColors(), new FilmColors()};
            scratch[depth] = known;
        }
        return known;
    }

    /** Makes all films black and fills the background of a tile in some, before its first level is composed. */
    public void fillBackground(HitRows rows, FilmParts parts, BitSet films, SamplePositions places, FilmColors to) {
        to.clear(parts.count() + FilmMixer.EARLIER_FILMS, places.count());
        for (int part = films.nextSetBit(0); part >= 0; part = films.nextSetBit(part + 1)) {
            if (rows.count < to.positions() && backgroundShader.showsBackground(parts, part)) {
                backgroundShader.shadeEyeRays(rows, parts, part, places, to.toWrite(part));
            }
        }
    }

    /**
     * Composes the rows of one level in some films.
     *
     * @param films    films to compose; none is dark
     * @param layers   layer of each light; unread if the light is dark
     * @param indirect indirect light of the rows; null for none
     * @param images   colors of the rays that bounce from the rows, by {@link BounceKind}; null if all are black
     * @param to       receives each row's linear color at its parent
     */
    public void composeLevel(HitRows rows, FilmParts parts, BitSet films, LightLayer[] layers, @Nullable IndirectRows indirect,
            FilmColors @Nullable [] images, FilmColors to) {
        composer.start(rows, indirect, films);
        for (int part = films.nextSetBit(0); part >= 0; part = films.nextSetBit(part + 1)) {
            composer.compose(rows, parts, part, layers, image(images, BounceKind.MIRRORED, part),
                    image(images, BounceKind.REFRACTED, part), to);
        }
    }

    /**
     * Composes only the rays that bounce from the rows of the level that was composed last.
     *
     * @param to receives each row's linear color at its parent
     */
    void composeImages(HitRows rows, BounceImages images, float[][] to) {
        composer.composeImages(rows, images, to);
    }

    private static float @Nullable [][] image(FilmColors @Nullable [] images, BounceKind bounce, int part) {
        return images == null ? null : images[bounce.ordinal()].get(part);
    }

    /** Sets the components that are composed from now on; initially all. */
    public void setComponents(Set<LightComponent> v) {
        composer.setComponents(v);
    }
}
