package lightning.format.layer;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import lightning.base.math.Ray;
import lightning.format.exr.ExrAttribute;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrType;
import lightning.render.cache.PixelCache;
import lightning.render.engine.Engine;
import lightning.render.trace.PixelRays;

/**
 * Alpha, and surface data averaged over the samples that a pixel's color is the mean of. Alpha is the share of samples whose ray hits a
 * surface, faces of lights included. Normals and colors are means over all samples, with 0 for the background, as denoisers expect.
 * Positions and depths are means over the samples that hit a surface, because the background has none.
 */
final class FilteredChannels implements ChannelSource {
    private static final String SUFFIX = "_filtered";

    private final PixelCache cache;
    private final ExrType colorType;
    private final SurfaceValues values;
    private final PixelRays eye;

    /** @param colorType type of alpha, normals and colors; all other channels are FLOAT */
    FilteredChannels(PixelCache cache, ExrType colorType) {
        this.cache = cache;
        this.colorType = colorType;
        values = SurfaceValues.of(cache);
        eye = new PixelRays(cache.scene());
    }

    /** Returns whether any pixel has several samples: else averages equal the surface data of its center. */
    private boolean hasAverages() {
        return cache.scene().picture().sampling().isSupersampled();
    }

    @Override
    public List<ExrChannel> channels() {
        List<ExrChannel> channels = new ArrayList<>(List.of(new ExrChannel("A", colorType)));
        if (hasAverages()) {
            channels.addAll(SurfaceValues.channels(SUFFIX, "Z" + SUFFIX + ".Z", colorType));
        }
        return channels;
    }

    @Override
    public Map<String, ExrAttribute> attributes() {
        return Map.of();
    }

    @Override
    public TileWriter writer(Engine engine) {
        PixelHits hits = new PixelHits(cache, engine);
        var means = new Means();
        return (tile, centers, sink) -> {
            hits.trace(tile, centers);
            sink.forEachPixel((x, y, pixel) -> {
                sink.put(0, x, y, (float) hitCount(hits, pixel) / hits.count(pixel));
                if (hasAverages()) {
                    means.compute(hits, x, y, pixel);
                    for (int i = 0; i < SurfaceValues.COUNT; i++) {
                        sink.put(1 + i, x, y, means.result[i]);
                    }
                }
            });
        };
    }

    private static int hitCount(PixelHits hits, int pixel) {
        int count = 0;
        for (int sample = 0; sample < hits.count(pixel); sample++) {
            count += hits.primitive(pixel, sample) < 0 ? 0 : 1;
        }
        return count;
    }

    /** Means of a pixel. Reused. */
    private final class Means {
        private final float[] sampleValues = new float[SurfaceValues.COUNT];
        private final double[] sums = new double[SurfaceValues.COUNT];
        private final float[] result = new float[SurfaceValues.COUNT];

        void compute(PixelHits hits, int x, int y, int pixel) {
            Arrays.fill(sums, 0);
            int count = 0;
            for (int sample = 0; sample < hits.count(pixel); sample++) {
                int primitive = hits.primitive(pixel, sample);
                if (primitive >= 0) {
                    Ray ray = eye.ray(x, y, hits.cell(pixel, sample), hits.grid(pixel, sample));
                    values.write(primitive, ray, sampleValues);
                    for (int i = 0; i < sums.length; i++) {
                        sums[i] += sampleValues[i];
                    }
                    count++;
                }
            }
            for (int i = 0; i < sums.length; i++) {
                boolean isPlace = i >= SurfaceValues.POSITION && i <= SurfaceValues.DEPTH;
                result[i] = count == 0 ? i == SurfaceValues.DEPTH ? SurfaceValues.BACKGROUND_DEPTH : 0
                        : (float) (sums[i] / (isPlace ? count : hits.count(pixel)));
            }
        }
    }
}
