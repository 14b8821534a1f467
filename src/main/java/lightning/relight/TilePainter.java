package lightning.relight;

import lightning.cache.PixelCache;
import lightning.cache.TileLevel;
import lightning.image.Film;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.shading.Lamp;
import lightning.shading.TileComposer;
import lightning.shading.ViewEffects;

/**
 * Composes tiles from layers that are known, whatever was composed of them before: no ray is cast and no light's term
 * computed. Holds scratch memory: one for each thread.
 */
final class TilePainter {
    private final TileComposer direct;
    private final TileComposer reflected;

    TilePainter(PixelCache cache, ViewEffects view) {
        direct = new TileComposer(cache.geometry().materials(), view);
        reflected = new TileComposer(cache.mirroredGeometry().materials(), view);
    }

    /**
     * Cr of the first level's reflective rows: red, green and blue columns of scratch memory, valid until the next call;
     * null where it has none.
     *
     * @param levels all of them, lit by {@code lamps} from the second on
     */
    float[][] mirrored(TileLevel[] levels, Lamp[] lamps, World world) {
        if (levels[0].rows().reflective == 0) {
            return null;
        }
        float[][] cr = reflected.unfollowed(levels[levels.length - 1].rows());
        for (int k = levels.length - 1; k > 0; k--) {
            reflected.level(levels[k].rows(), lamps, levels[k].layers(), null, world, cr);
            cr = reflected.followed(levels[k - 1].rows(), levels[k].rows(), world);
        }
        return cr;
    }

    /** The tile of the film: red, green, blue, {@code float[1024]} each. */
    float[][] film(TileLevel top, Lamp[] lamps, World world, float[][] cr) {
        float[][] pixels = new float[3][Film.TILE_PIXELS];
        direct.level(top.rows(), lamps, top.layers(), null, world, cr);
        direct.toFilm(top.rows(), world, pixels[0], pixels[1], pixels[2]);
        return pixels;
    }
}
