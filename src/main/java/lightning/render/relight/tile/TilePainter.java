package lightning.render.relight.tile;

import lightning.render.cache.PixelCache;
import lightning.render.cache.TileLevel;
import lightning.render.engine.Engine;
import lightning.render.image.Film;
import lightning.render.shading.Images;
import lightning.render.shading.Luminaire;
import lightning.render.shading.TileComposer;
import lightning.render.trace.Bounce;
import lightning.render.trace.HitRows;
import lightning.render.trace.SamplePlaces;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.effects.ViewEffects;

/**
 * Composes tiles from layers that are known, whatever was composed of them before: no ray is cast and no light's term
 * computed. Holds scratch memory: one for each thread.
 */
public final class TilePainter {
    private final TileComposer eye;
    private final TileComposer mirror;
    private final int depth;
    /** The level to be composed next. */
    private int next;

    public TilePainter(PixelCache cache, Engine engine, ViewEffects view) {
        depth = cache.scene().picture().depth();
        eye = new TileComposer(cache.geometry().materials(), engine.sums(), view);
        mirror = new TileComposer(cache.geometry().of(cache.mirroredScene()).materials(), engine.sums(), view);
    }

    /**
     * What the rays bring that go on from the first level's rows: scratch memory, valid until the next call; null where none does.
     *
     * @param levels all of them, lit by {@code lights} from the second on
     */
    public Images images(TileLevel[] levels, Luminaire[] lights, World world) {
        next = 1;
        return images(levels, 0, 0, lights, world);
    }

    private Images images(TileLevel[] levels, int of, int level, Luminaire[] lights, World world) {
        HitRows rows = levels[of].rows();
        if (level == depth || rows.reflective == 0) {
            return mirror.unfollowed(rows, level);
        }
        Images images = mirror.followed(rows, world, level);
        for (Bounce bounce : Bounce.values()) {
            if (bounce.rows(rows) > 0) {
                int at = next++;
                Images below = images(levels, at, level + 1, lights, world);
                mirror.level(levels[at].rows(), lights, levels[at].layers(), null, world, below, images.of(bounce));
            }
        }
        return images;
    }

    /** The tile of the film: red, green, blue, {@code float[1024]} each. */
    public float[][] film(TileLevel top, Luminaire[] lights, Scene scene, SamplePlaces places, Images images) {
        float[][] pixels = new float[3][Film.TILE_PIXELS];
        eye.background(top.rows(), scene, places, pixels);
        eye.level(top.rows(), lights, top.layers(), null, scene.world(), images, pixels);
        return pixels;
    }
}
