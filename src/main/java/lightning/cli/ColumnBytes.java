package lightning.cli;

import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.Map;
import lightning.render.cache.CachedTile;
import lightning.render.cache.PixelCache;
import lightning.render.cache.TileLevel;
import lightning.render.shading.layer.LightLayer;
import lightning.render.shading.layer.LightRows;
import lightning.render.trace.HitRows;

/**
 * Bytes of a cache by kind of column, without the film and array headers.
 *
 * @param rowCount shading points of all levels
 * @param layerRowCount rows of all layers: a shading point counts once for each light
 * @param hitColumns columns of the shading points, by column group
 * @param layerColumns columns of the light layers by title, in order; shared columns count once
 * @param indirectBytes columns of indirect light by title, in order; empty without it
 * @param mirrorBytes colors of reflected images, and the shapes that mirrored rays hit
 * @param total bytes of the whole cache, as counted by the cache
 */
record ColumnBytes(long rowCount, long layerRowCount, Map<HitRows.ColumnGroup, Long> hitColumns, Map<String, Long> layerColumns,
        Map<String, Long> indirectBytes, long mirrorBytes, long total) {
    static ColumnBytes of(PixelCache cache) {
        long layerRows = 0;
        long levels = 0;
        long weights = 0;
        Map<HitRows.ColumnGroup, Long> hits = new EnumMap<>(HitRows.ColumnGroup.class);
        Map<String, Long> layers = new LinkedHashMap<>();
        for (CachedTile tile : cache.allTiles()) {
            for (TileLevel level : tile.levels()) {
                HitRows rows = level.rows();
                levels += level.bytes();
                weights += level.weights() == null ? 0 : level.weights().bytes();
                for (HitRows.ColumnGroup part : HitRows.ColumnGroup.values()) {
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
        Map<String, Long> indirect = new LinkedHashMap<>();
        if (cache.indirect() != null) {
            indirect.put("paths of indirect light", cache.indirectBytes());
            indirect.put("weights of gather points", weights);
        }
        return new ColumnBytes(cache.rowCount(), layerRows, hits, layers, indirect, cache.bytes() - levels - cache.indirectBytes(),
                cache.bytes());
    }
}
