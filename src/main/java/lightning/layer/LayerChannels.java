package lightning.layer;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.format.exr.ExrAttribute;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrPrimaries;
import lightning.format.exr.ExrType;
import lightning.render.cache.CachedTile;
import lightning.render.cache.PixelCache;
import lightning.render.engine.Engine;
import lightning.render.engine.EngineChoice;
import lightning.render.image.Film;
import lightning.render.shading.FilmParts;
import lightning.render.trace.SamplePositions;
import lightning.scene.GatherSettings;
import tools.jackson.databind.json.JsonMapper;

/** Color layers of an image, which add up to it (see {@link LayerSum}). The header contains the order of the sum. */
final class LayerChannels implements ChannelSource {
    private static final List<String> COLORS = List.of("R", "G", "B");
    private static final String ROUNDING = "rounding";

    private final PixelCache cache;
    private final Film film;
    private final ExrType type;
    private final ExrPrimaries primaries;
    private final EngineChoice engines;
    private final List<LightSet> sets;
    /** Whether each set of lights has a layer of its reflections. */
    private final boolean mirrorsSets;
    private final List<Layer> layers;
    /** Names of the layers, without the residual. */
    private final List<String> names;
    private final FilmParts parts;
    /** Films of each set, and last those of no set. */
    private final List<BitSet> films;

    /**
     * @param cache cache of a finished image
     * @param type HALF or FLOAT; halves have no residual layer
     * @param all true for layers of lights that are off too
     * @param primaries color space of the layers
     * @param grouped true for layers of light groups in place of their lights
     */
    LayerChannels(PixelCache cache, EngineChoice engines, ExrType type, ExrPrimaries primaries, boolean all, boolean grouped) {
        this.cache = cache;
        this.type = type;
        this.primaries = primaries;
        film = cache.film();
        this.engines = engines;
        sets = LightSet.of(cache.scene(), all, grouped);
        mirrorsSets = Layer.canShowReflections(cache.scene(), all) && cache.allTiles().stream().allMatch(CachedTile::storesRows);
        parts = cache.parts();
        films = LightSet.films(sets, parts);
        layers = Layer.of(cache.scene(), sets, mirrorsSets, all);
        names = LayerNames.of(layers, GatherSettings.of(cache.scene()));
    }

    private boolean isExact() {
        return type == ExrType.FLOAT;
    }

    /** Returns the names of all layers, in the order of the sum. */
    List<String> layerNames() {
        List<String> all = new ArrayList<>(names);
        if (isExact()) {
            all.add(ROUNDING);
        }
        return all;
    }

    @Override
    public List<ExrChannel> channels() {
        return layerNames().stream().flatMap(name -> COLORS.stream().map(color -> new ExrChannel(name + "." + color, type))).toList();
    }

    @Override
    public Map<String, ExrAttribute> attributes() {
        Map<String, String> lights = new LinkedHashMap<>();
        for (int i = 0; i < names.size(); i++) {
            if (layers.get(i) instanceof Layer.OfLights some) {
                lights.put(names.get(i), some.lights().name());
            }
        }
        JsonMapper json = new JsonMapper();
        return Map.of("lightning/sum", new ExrAttribute.Text(json.writeValueAsString(layerNames())), "lightning/lights",
                new ExrAttribute.Text(json.writeValueAsString(lights)));
    }

    @Override
    public TileWriter writer(Engine engine) {
        LayerCompositor painter = new LayerCompositor(cache, parts, films, mirrorsSets, engine);
        return (tile, centers, sink) -> {
            LayerSum layerSum = new LayerSum(Film.TILE_PIXELS);
            for (int k = 0; k < layers.size(); k++) {
                float[][] layer = primaries.convert(layerPixels(painter, layers.get(k), tile, centers));
                layerSum.add(layer);
                sink.putColors(3 * k, layer);
            }
            if (isExact()) {
                sink.putColors(3 * layers.size(), layerSum
                        .residual(primaries.convert(new float[][] {film.red(tile), film.green(tile), film.blue(tile)})));
            }
        };
    }

    /** Returns the pixels of a layer's tile, averaged over samples if it has several. */
    private float[][] layerPixels(LayerCompositor painter, Layer layer, int tile, SamplePositions centers) {
        float[][] center = cache.tileCount() == 0 ? null : painter.colors(layer, cache.tile(tile), centers);
        return cache.fineCount() == 0 ? requireNonNull(center)
                : cache.fineTile(tile).film(center, centers, (block, places) -> painter.colors(layer, block, places));
    }
}
