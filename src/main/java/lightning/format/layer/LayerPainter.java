package lightning.format.layer;

import java.util.Arrays;
import lightning.render.cache.CachedTile;
import lightning.render.cache.PixelCache;
import lightning.render.engine.Engine;
import lightning.render.image.Film;
import lightning.render.shading.Images;
import lightning.render.shading.LightLayer;
import lightning.render.shading.LightPart;
import lightning.render.shading.Luminaire;
import lightning.render.shading.TileComposer;
import lightning.render.trace.HitRows;
import lightning.render.trace.SamplePlaces;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.effects.ViewEffects;

/**
 * Composes single layers of tiles from what is known of them: no ray is cast and no light's term computed. Holds scratch memory: one for
 * each thread.
 */
final class LayerPainter {
    private static final Luminaire[] NO_LIGHTS = {};
    private static final LightLayer[] NO_LAYERS = {};
    private static final Images BLACK = new Images(new float[3][Film.TILE_PIXELS], new float[3][Film.TILE_PIXELS]);

    private final Scene scene;
    private final World dark;
    private final Luminaire[] lights;
    private final TileComposer composer;

    LayerPainter(PixelCache cache, Engine engine) {
        scene = cache.scene();
        dark = scene.world().withAmbience(0);
        lights = Luminaire.all(scene);
        composer = new TileComposer(cache.geometry().materials(), engine.sums(), ViewEffects.ALL);
    }

    /** The colours of a layer: red, green, blue, {@code float[1024]} each; of a block of samples those of the samples. */
    float[][] colors(Layer layer, CachedTile tile, SamplePlaces places) {
        float[][] to = new float[3][Film.TILE_PIXELS];
        HitRows rows = tile.rows();
        switch (layer) {
            case Layer.Background _ -> {
                composer.background(rows, scene, places, to);
                composer.level(rows, NO_LIGHTS, NO_LAYERS, null, dark, BLACK, to);
            }
            case Layer.Ambient _ -> composer.level(rows, NO_LIGHTS, NO_LAYERS, null, scene.world(), BLACK, to);
            case Layer.Reflections _ -> {
                if (rows.reflective > 0) {
                    composer.level(rows, NO_LIGHTS, NO_LAYERS, null, dark, tile.images, to);
                }
            }
            case Layer.Lights some -> {
                composer.setPart(some.part());
                composer.level(rows, Arrays.copyOfRange(lights, some.first(), some.end()),
                        Arrays.copyOfRange(tile.levels[0].layers(), some.first(), some.end()), null, dark, BLACK, to);
                composer.setPart(LightPart.ALL);
            }
        }
        return to;
    }
}
