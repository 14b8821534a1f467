package lightning.format.layer;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.render.cache.CachedTile;
import lightning.render.cache.PixelCache;
import lightning.render.cache.TileLevel;
import lightning.render.engine.Engine;
import lightning.render.image.Film;
import lightning.render.relight.LightImage;
import lightning.render.relight.tile.TileRecomposer;
import lightning.render.shading.BounceImages;
import lightning.render.shading.IndirectRows;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.composition.LightComponent;
import lightning.render.shading.composition.TileComposer;
import lightning.render.shading.fog.BounceFog;
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
    private final Scene mirrored;
    private final World darkMirroredWorld;
    /** Light of each set, and last that of no set. */
    private final List<SetLight> sets;
    /** Whether each set has a layer of its reflections. */
    private final boolean mirrorsSets;
    private final TileComposer composer;
    /** Composers of what mirrors show of the lights of sets, and of all else. */
    private final TileRecomposer ofSets;
    private final TileRecomposer ofRest;
    private final FogComposer fogComposer = new FogComposer();

    /**
     * @param sets        light of each set of lights, and last that of no set
     * @param mirrorsSets whether each set has a layer of its reflections
     */
    LayerCompositor(PixelCache cache, List<SetLight> sets, boolean mirrorsSets, Engine engine) {
        this.sets = sets;
        this.mirrorsSets = mirrorsSets;
        scene = cache.scene();
        darkWorld = scene.world().withAmbience(0);
        mirrored = cache.mirrored().scene();
        darkMirroredWorld = LightImage.darkWorld(mirrored.world());
        composer = new TileComposer(scene, cache.geometry().materials(), engine.sums(), ViewEffects.ALL);
        composer.setShowsGlow(false);
        ofSets = new TileRecomposer(cache, engine, ViewEffects.ALL);
        ofSets.setShowsGlow(false);
        ofSets.setMirrorFog(BounceFog.of(mirrored.withWorld(darkMirroredWorld), cache.mirrored().fog()));
        ofRest = new TileRecomposer(cache, engine, ViewEffects.ALL);
        ofRest.setMirrorFog(BounceFog.of(mirrored, cache.mirrored().fog()));
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
            case Layer.OfLights some -> addPart(some, sets.get(some.set()), samplePositions, tile, result);
            case Layer.Gathered _ -> addGathered(tile.levels[0], sets.getLast().gathered(), result);
            case Layer.Reflections _ -> addReflections(rows,
                    mirrorsSets ? images(ofRest, sets.getLast(), samplePositions, tile, mirrored.world()) : tile.images, result);
        }
        if (tile.fog != null) {
            addFog(layer, tile.fog, result);
        }
        return result;
    }

    private void addPart(Layer.OfLights some, SetLight light, SamplePositions places, CachedTile tile, float[][] to) {
        if (!light.shines()) {
            return;
        }
        HitRows rows = tile.rows();
        switch (some.part()) {
            case DIFFUSE -> addDirect(LightComponent.DIFFUSE, some, light, tile, to);
            case SPECULAR -> addDirect(LightComponent.SPECULAR, some, light, tile, to);
            case GATHERED -> addGathered(tile.levels[0], light.gathered(), to);
            case REFLECTIONS -> addReflections(rows, images(ofSets, light, places, tile, darkMirroredWorld), to);
            // Fog is added to all layers.
            case FOG -> {
            }
        }
    }

    private void addDirect(LightComponent component, Layer.OfLights some, SetLight light, CachedTile tile, float[][] to) {
        List<WeightedLight> lights = new ArrayList<>();
        List<LightLayer> layers = new ArrayList<>();
        for (int i : some.lights().indices(scene)) {
            if (!light.lights()[i].isDark()) {
                lights.add(light.lights()[i]);
                layers.add(tile.levels[0].layers()[i]);
            }
        }
        if (!lights.isEmpty()) {
            composer.setComponent(component);
            composer.composeLevel(tile.rows(), lights.toArray(WeightedLight[]::new), layers.toArray(LightLayer[]::new), darkWorld, BLACK,
                    to);
            composer.setComponent(LightComponent.ALL);
        }
    }

    private void addGathered(TileLevel level, float @Nullable [][] light, float[][] to) {
        if (light != null) {
            composer.composeLevel(level.rows(), NO_LIGHTS, NO_LAYERS, darkWorld, new IndirectRows(requireNonNull(level.weights()), light),
                    BLACK,
                    to);
        }
    }

    private void addReflections(HitRows rows, @Nullable BounceImages images, float[][] to) {
        if (rows.reflectiveCount > 0) {
            composer.composeLevel(rows, NO_LIGHTS, NO_LAYERS, darkWorld, images, to);
        }
    }

    private static @Nullable BounceImages images(TileRecomposer recomposer, SetLight light, SamplePositions places, CachedTile tile,
            World world) {
        recomposer.setIndirect(light.gathered(), light.mirroredGathered());
        return tile.rows().reflectiveCount == 0 ? null : recomposer.composeImages(places, tile.levels, light.mirrored(), world);
    }

    /** Dims a layer by fog, and adds what fog itself shows: a part of each set's light, and ambient light to the ambient layer. */
    private void addFog(Layer layer, FogTile tile, float[][] colors) {
        Fog fog = scene.world().fog();
        boolean isLit = layer instanceof Layer.OfLights some && some.part() == LightPart.FOG;
        WeightedLight[] lights = isLit ? sets.get(((Layer.OfLights) layer).set()).lights() : NO_LIGHTS;
        fogComposer.add(tile, lights, 0, lights.length, fog.color(), layer instanceof Layer.Ambient ? fog.ambient() : Rgb.BLACK, colors);
    }
}
