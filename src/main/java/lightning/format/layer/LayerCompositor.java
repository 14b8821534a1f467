package lightning.format.layer;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.base.math.Rgb;
import lightning.render.cache.CachedTile;
import lightning.render.cache.PixelCache;
import lightning.render.engine.Engine;
import lightning.render.image.Film;
import lightning.render.shading.BounceImages;
import lightning.render.shading.IndirectRows;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.composition.LightComponent;
import lightning.render.shading.composition.TileComposer;
import lightning.render.shading.fog.FogComposer;
import lightning.render.shading.fog.FogTile;
import lightning.render.shading.layer.LightLayer;
import lightning.render.trace.HitRows;
import lightning.render.trace.SamplePositions;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.effects.ViewEffects;
import lightning.scene.value.Fog;
import org.jspecify.annotations.Nullable;

/**
 * Compositor of single tile layers from cached data: casts no rays and evaluates no lights. Contains scratch memory; use one
 * per thread.
 */
final class LayerCompositor {
    private static final WeightedLight[] NO_LIGHTS = {};
    private static final LightLayer[] NO_LAYERS = {};
    private static final BounceImages BLACK = new BounceImages(new float[3][Film.TILE_PIXELS], new float[3][Film.TILE_PIXELS]);

    private final Scene scene;
    private final World darkWorld;
    private final WeightedLight[] lights;
    /** Indirect light at gather points; null if the scene has none. */
    private final float @Nullable [][] indirect;
    private final TileComposer composer;
    private final FogComposer fogComposer = new FogComposer();

    LayerCompositor(PixelCache cache, Engine engine) {
        scene = cache.scene();
        darkWorld = scene.world().withAmbience(0);
        lights = WeightedLight.ofScene(scene);
        indirect = cache.indirect() == null ? null : cache.indirect().light().light();
        composer = new TileComposer(scene, cache.geometry().materials(), engine.sums(), ViewEffects.ALL);
        composer.setShowsGlow(false);
    }

    /** Returns the colors of a layer: red, green, blue, {@code float[1024]} each; for a block of samples those of the samples. */
    float[][] colors(Layer layer, CachedTile tile, SamplePositions samplePositions) {
        float[][] result = new float[3][Film.TILE_PIXELS];
        HitRows rows = tile.rows();
        switch (layer) {
            case Layer.Background _ -> {
                composer.fillBackground(rows, scene, samplePositions, result);
                composer.composeLevel(rows, NO_LIGHTS, NO_LAYERS, darkWorld, BLACK, result);
            }
            case Layer.Ambient _ -> composer.composeLevel(rows, NO_LIGHTS, NO_LAYERS, scene.world(), BLACK, result);
            case Layer.Emission _ -> {
                composer.setShowsGlow(true);
                composer.composeLevel(rows, NO_LIGHTS, NO_LAYERS, darkWorld, BLACK, result);
                composer.setShowsGlow(false);
            }
            case Layer.Gathered _ -> composer.composeLevel(rows, NO_LIGHTS, NO_LAYERS, darkWorld,
                    new IndirectRows(requireNonNull(tile.levels[0].weights()), requireNonNull(indirect)), BLACK, result);
            case Layer.Reflections _ -> {
                if (rows.reflectiveCount > 0) {
                    composer.composeLevel(rows, NO_LIGHTS, NO_LAYERS, darkWorld, tile.images, result);
                }
            }
            case Layer.Lights some -> {
                if (some.end() == some.first() + 1 && lights[some.first()].isDark()) {
                    break;
                }
                composer.setComponent(some.part());
                composer.composeLevel(rows, Arrays.copyOfRange(lights, some.first(), some.end()),
                        Arrays.copyOfRange(tile.levels[0].layers(), some.first(), some.end()), darkWorld, BLACK, result);
                composer.setComponent(LightComponent.ALL);
            }
        }
        if (tile.fog != null) {
            addFog(layer, tile.fog, result);
        }
        return result;
    }

    /** Dims a layer by fog. Light of lamps in the fog belongs to their diffuse layers, ambient light to the ambient layer. */
    private void addFog(Layer layer, FogTile tile, float[][] colors) {
        Fog fog = scene.world().fog();
        int from = 0;
        int to = 0;
        if (layer instanceof Layer.Lights some && some.part() != LightComponent.SPECULAR) {
            from = some.first();
            to = some.end();
        }
        fogComposer.add(tile, lights, from, to, fog.color(), layer instanceof Layer.Ambient ? fog.ambient() : Rgb.BLACK, colors);
    }
}
