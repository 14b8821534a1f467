package lightning.layer;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import lightning.format.exr.ExrAttribute;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrType;
import lightning.format.matte.CoverageRanking;
import lightning.format.matte.MatteKind;
import lightning.format.matte.MatteTable;
import lightning.render.cache.PixelCache;
import lightning.render.engine.Engine;
import lightning.render.trace.Geometry;

/**
 * Mattes by Cryptomatte's specification: for each kind, numbered layers of two ids and their coverages. An object's coverage is the
 * share of a pixel's samples whose camera ray hits it first, so mirrors and glass count as themselves. Background and faces of lights
 * have no id.
 */
final class MatteChannels implements ChannelSource {
    /** Id and coverage of an even rank, then of an odd one. */
    private static final List<String> COMPONENTS = List.of("R", "G", "B", "A");

    private final PixelCache cache;
    private final int levels;
    private final List<MatteTable> tables;
    private final AtomicInteger crowdedPixels = new AtomicInteger();
    private final AtomicInteger maxIds = new AtomicInteger();

    /** @param levels ids for which each pixel has room, even */
    MatteChannels(PixelCache cache, int levels) {
        this.cache = cache;
        this.levels = levels;
        tables = Arrays.stream(MatteKind.values()).map(kind -> new MatteTable(kind, cache.scene().stage())).toList();
    }

    @Override
    public List<ExrChannel> channels() {
        List<ExrChannel> channels = new ArrayList<>();
        for (MatteKind kind : MatteKind.values()) {
            for (int level = 0; level < levels; level += 2) {
                String layer = String.format(Locale.ROOT, "%s%02d", kind.layer(), level / 2);
                COMPONENTS.forEach(component -> channels.add(new ExrChannel(layer + "." + component, ExrType.FLOAT)));
            }
        }
        return channels;
    }

    @Override
    public Map<String, ExrAttribute> attributes() {
        Map<String, ExrAttribute> attributes = new LinkedHashMap<>();
        tables.forEach(table -> attributes.putAll(table.attributes()));
        return attributes;
    }

    /** Drops the counts of pixels that were written so far. */
    void clearCounts() {
        crowdedPixels.set(0);
        maxIds.set(0);
    }

    /** Returns the number of written pixels that show more ids than there are levels. */
    int crowdedPixels() {
        return crowdedPixels.get();
    }

    /** Returns the largest number of ids of a written pixel. */
    int maxIds() {
        return maxIds.get();
    }

    @Override
    public TileWriter writer(Engine engine) {
        PixelHits hits = new PixelHits(cache, engine);
        CoverageRanking ranking = new CoverageRanking();
        float[] ranks = new float[2 * levels];
        return (tile, centers, sink) -> {
            hits.trace(tile, centers);
            sink.forEachPixel((x, y, pixel) -> {
                int mostIds = 0;
                for (int k = 0; k < tables.size(); k++) {
                    rank(hits, pixel, tables.get(k), ranking);
                    mostIds = Math.max(mostIds, ranking.size());
                    ranking.write(hits.count(pixel), ranks);
                    for (int i = 0; i < ranks.length; i++) {
                        sink.put(k * ranks.length + i, x, y, ranks[i]);
                    }
                }
                count(mostIds);
            });
        };
    }

    private void rank(PixelHits hits, int pixel, MatteTable table, CoverageRanking ranking) {
        Geometry geometry = cache.geometry();
        ranking.clear();
        for (int sample = 0; sample < hits.count(pixel); sample++) {
            int primitive = hits.primitive(pixel, sample);
            // Faces of lights are no objects.
            if (primitive >= 0 && !geometry.isLightFace(primitive)) {
                ranking.add(table.bits(geometry.owner(primitive)));
            }
        }
    }

    private void count(int ids) {
        if (ids > levels) {
            crowdedPixels.incrementAndGet();
        }
        if (ids > maxIds.get()) {
            maxIds.accumulateAndGet(ids, Math::max);
        }
    }
}
