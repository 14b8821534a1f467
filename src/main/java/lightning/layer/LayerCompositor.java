package lightning.layer;

import java.util.BitSet;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import lightning.render.cache.CachedTile;
import lightning.render.cache.PixelCache;
import lightning.render.cache.TileLevel;
import lightning.render.engine.Engine;
import lightning.render.image.Film;
import lightning.render.relight.tile.TileRecomposer;
import lightning.render.shading.FilmParts;
import lightning.render.shading.composition.FilmColors;
import lightning.render.shading.composition.LightComponent;
import lightning.render.shading.fog.FogComposer;
import lightning.render.trace.SamplePositions;
import lightning.scene.Contribution;
import lightning.scene.effects.ViewEffects;

/**
 * Compositor of single tile layers from cached data: casts no rays and evaluates no lights. Contains scratch memory; use one
 * per thread.
 */
final class LayerCompositor {
    private final PixelCache cache;
    private final FilmParts parts;
    /** Films of each set of lights, and last those of no set. */
    private final List<BitSet> sets;
    /** Whether each set has a layer of its reflections. */
    private final boolean mirrorsSets;
    private final TileRecomposer recomposer;
    private final FogComposer fogComposer = new FogComposer();
    private final FilmColors films = new FilmColors();

    /**
     * @param sets        films of each set of lights, and last those of no set
     * @param mirrorsSets whether each set has a layer of its reflections
     */
    LayerCompositor(PixelCache cache, FilmParts parts, List<BitSet> sets, boolean mirrorsSets, Engine engine) {
        this.cache = cache;
        this.parts = parts;
        this.sets = sets;
        this.mirrorsSets = mirrorsSets;
        recomposer = TileRecomposer.of(cache, engine, ViewEffects.ALL);
    }

    /** Returns the colors of a layer: red, green, blue, {@code float[1024]} each; for a block of samples those of the samples. */
    float[][] colors(Layer layer, CachedTile tile, SamplePositions places) {
        TileLevel top = tile.levels()[0];
        BitSet shining = parts.shining();
        switch (layer) {
            case Layer.Background _ -> recomposer.composeBackground(top, places, shining, films);
            case Layer.Ambient _ -> compose(LightComponent.EMITTED, top, of(new Contribution.OfAmbience()));
            case Layer.Emission _ -> {
                shining.andNot(of(new Contribution.OfAmbience()));
                compose(LightComponent.EMITTED, top, shining);
            }
            case Layer.OfLights some -> {
                switch (some.part()) {
                    case DIFFUSE -> compose(LightComponent.DIFFUSE, top, sets.get(some.set()));
                    case SPECULAR -> compose(LightComponent.SPECULAR, top, sets.get(some.set()));
                    case GATHERED -> compose(LightComponent.GATHERED, top, sets.get(some.set()));
                    case REFLECTIONS -> composeReflections(top, tile, places, sets.get(some.set()), false);
                    case FOG -> films.clear(recomposer.mixer().films());
                }
            }
            case Layer.Gathered _ -> compose(LightComponent.GATHERED, top, sets.getLast());
            case Layer.Reflections _ -> composeReflections(top, tile, places, mirrorsSets ? sets.getLast() : shining, true);
        }
        if (tile.fog() != null) {
            fogComposer.dim(tile.fog(), parts, films);
            if (layer instanceof Layer.OfLights some && some.part() == LightPart.FOG) {
                fogComposer.add(tile.fog(), parts, sets.get(some.set()), parts.scene().world().fog(), films);
            }
            if (layer instanceof Layer.Ambient) {
                fogComposer.add(tile.fog(), parts, of(new Contribution.OfRest()), parts.scene().world().fog(), films);
            }
        }
        float[][] result = new float[3][Film.TILE_PIXELS];
        recomposer.mixer().mix(films::get, result);
        return result;
    }

    private BitSet of(Contribution contribution) {
        BitSet some = parts.of(contribution);
        some.and(parts.shining());
        return some;
    }

    private void compose(LightComponent component, TileLevel top, BitSet some) {
        recomposer.composeComponents(EnumSet.of(component), top, some, null, films);
    }

    /** Mirrors that show an earlier scene, or of which the rows were not kept, belong to no set. */
    private void composeReflections(TileLevel top, CachedTile tile, SamplePositions places, BitSet some, boolean isRest) {
        Set<LightComponent> bounced = EnumSet.of(LightComponent.BOUNCED);
        if (tile.storesRows() && !cache.areMirrorsOutdated()) {
            recomposer.composeComponents(bounced, top, some, recomposer.composeImages(places, tile.levels().clone(), some), films);
            return;
        }
        recomposer.composeComponents(bounced, top, new BitSet(), null, films);
        if (tile.images() != null && isRest) {
            recomposer.addEarlierMirrors(top, tile.images(), films);
        }
    }
}
