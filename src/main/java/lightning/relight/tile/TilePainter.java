package lightning.relight.tile;

import lightning.cache.PixelCache;
import lightning.cache.TileLevel;
import lightning.effects.ViewEffects;
import lightning.engine.Engine;
import lightning.image.Film;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.shading.Luminaire;
import lightning.shading.TileComposer;
import lightning.trace.SamplePlaces;

/**
 * Composes tiles from layers that are known, whatever was composed of them before: no ray is cast and no light's term
 * computed. Holds scratch memory: one for each thread.
 */
public final class TilePainter {
    private final TileComposer eye;
    private final TileComposer mirror;

    public TilePainter(PixelCache cache, Engine engine, ViewEffects view) {
        eye = new TileComposer(cache.geometry().materials(), engine.sums(), view);
        mirror = new TileComposer(cache.geometry().of(cache.mirroredScene()).materials(), engine.sums(), view);
    }

    /**
     * Cr of the first level's reflective rows: red, green and blue columns of scratch memory, valid until the next call;
     * null where it has none.
     *
     * @param levels all of them, lit by {@code lights} from the second on
     */
    public float[][] mirrored(TileLevel[] levels, Luminaire[] lights, World world) {
        if (levels[0].rows().reflective == 0) {
            return null;
        }
        float[][] cr = mirror.unfollowed(levels[levels.length - 1].rows());
        for (int k = levels.length - 1; k > 0; k--) {
            float[][] above = mirror.followed(levels[k - 1].rows(), world);
            mirror.level(levels[k].rows(), lights, levels[k].layers(), null, world, cr, above);
            cr = above;
        }
        return cr;
    }

    /** The tile of the film: red, green, blue, {@code float[1024]} each. */
    public float[][] film(TileLevel top, Luminaire[] lights, Scene scene, SamplePlaces places, float[][] cr) {
        float[][] pixels = new float[3][Film.TILE_PIXELS];
        eye.background(top.rows(), scene, places, pixels);
        eye.level(top.rows(), lights, top.layers(), null, scene.world(), cr, pixels);
        return pixels;
    }
}
