package lightning.cli;

import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.Map;
import lightning.render.cache.CachedTile;
import lightning.render.cache.PixelCache;
import lightning.render.cache.TileLevel;
import lightning.render.shading.LightLayer;
import lightning.render.shading.LightRows;
import lightning.render.trace.HitRows;

/**
 * The bytes of a cache by kind of column, the film and array headers left out.
 *
 * @param rows      hit rows of all levels
 * @param layerRows rows of all layers: a row counts once for each light
 * @param hits      the columns of hit rows, by what they come and go with
 * @param layers    the columns of the lights' layers by their titles, in their order: what is kept in several counts once
 * @param mirrored  colours of mirror images, and the shapes that mirrored rays hit
 * @param all       everything, as the cache itself counts
 */
record ColumnBytes(long rows, long layerRows, Map<HitRows.Part, Long> hits, Map<String, Long> layers, long mirrored, long all) {
    static ColumnBytes of(PixelCache cache) {
        long layerRows = 0;
        long levels = 0;
        Map<HitRows.Part, Long> hits = new EnumMap<>(HitRows.Part.class);
        Map<String, Long> layers = new LinkedHashMap<>();
        for (CachedTile tile : cache.all()) {
            for (TileLevel level : tile.levels) {
                HitRows rows = level.rows();
                levels += level.bytes();
                for (HitRows.Part part : HitRows.Part.values()) {
                    hits.merge(part, rows.bytes(part), Long::sum);
                }
                for (LightLayer layer : level.layers()) {
                    if (layer instanceof LightRows l) {
                        layerRows += rows.count;
                        for (LightRows.Column column : LightRows.Column.values()) {
                            layers.merge(column.title(), l.bytes(column), Long::sum);
                        }
                    }
                }
            }
        }
        return new ColumnBytes(cache.rowCount(), layerRows, hits, layers, cache.bytes() - levels, cache.bytes());
    }
}
