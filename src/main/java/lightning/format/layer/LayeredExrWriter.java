package lightning.format.layer;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.base.file.AtomicFile;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrChunk;
import lightning.format.exr.ExrHeader;
import lightning.format.exr.ExrType;
import lightning.format.exr.ExrWriter;
import lightning.render.cache.CachedTile;
import lightning.render.cache.PixelCache;
import lightning.render.engine.EngineChoice;
import lightning.render.engine.EngineWorkers;
import lightning.render.image.Film;
import lightning.render.trace.SamplePositions;
import lightning.scene.Material;
import lightning.scene.Scene;
import lightning.scene.Shape;
import tools.jackson.databind.json.JsonMapper;

/**
 * Writer for an image with its layers in one OpenEXR file, one row of tiles at a time. Channels R, G and B are the image.
 * All other colors add up to it (see {@link LayerSum}); the header contains the summation order and the names of shapes and
 * materials by id.
 */
public final class LayeredExrWriter {
    private static final List<String> COLORS = List.of("R", "G", "B");
    private static final String ROUNDING = "rounding";
    /** Copies of a row of tiles per worker: raw, shuffled, compressed, and compressed while queued. */
    private static final int COPIES_PER_WORKER = 4;

    private final PixelCache cache;
    private final EngineChoice engines;
    private final Scene scene;
    private final Film film;
    private final boolean isExact;
    private final List<Layer> layers;
    private final ExrHeader header;
    /** Channel indices of red, green and blue for the image, each layer and the residual. */
    private final int[][] colorChannels;
    private final int[] surfaceChannels;

    /**
     * Creates a writer.
     *
     * @param cache cache of a finished image
     * @param type type of colors and normals, HALF or FLOAT; all other channels are FLOAT. A file of halves has no residual
     *     layer
     */
    public LayeredExrWriter(PixelCache cache, EngineChoice engines, ExrType type) {
        this.cache = cache;
        this.engines = engines;
        scene = cache.scene();
        film = cache.film();
        isExact = type == ExrType.FLOAT;
        layers = Layer.of(scene);
        List<String> names = new ArrayList<>(List.of(""));
        LayerNames.of(layers).forEach(name -> names.add(name + "."));
        if (isExact) {
            names.add(ROUNDING + ".");
        }
        List<ExrChannel> channels = new ArrayList<>();
        names.forEach(name -> COLORS.forEach(color -> channels.add(new ExrChannel(name + color, type))));
        SurfaceChannels.CHANNELS.forEach(name -> channels.add(new ExrChannel(name, name.startsWith("N.") ? type : ExrType.FLOAT)));
        header = new ExrHeader(film.width(), film.height(), channels, attributes());
        List<String> channelNames = header.channels().stream().map(ExrChannel::name).toList();
        colorChannels = names.stream().map(name -> COLORS.stream().mapToInt(color -> channelNames.indexOf(name + color)).toArray())
                .toArray(int[][]::new);
        surfaceChannels = SurfaceChannels.CHANNELS.stream().mapToInt(channelNames::indexOf).toArray();
    }

    private Map<String, String> attributes() {
        List<String> names = LayerNames.of(layers);
        List<String> sum = new ArrayList<>(names);
        if (isExact) {
            sum.add(ROUNDING);
        }
        Map<String, String> lights = new LinkedHashMap<>();
        for (int i = 0; i < names.size(); i++) {
            if (layers.get(i) instanceof Layer.Lights light) {
                lights.put(names.get(i), light.name());
            }
        }
        JsonMapper json = new JsonMapper();
        Map<String, String> attributes = new LinkedHashMap<>();
        attributes.put("software", "Lightning");
        attributes.put("lightning/sum", json.writeValueAsString(sum));
        attributes.put("lightning/lights", json.writeValueAsString(lights));
        attributes.put("lightning/shapes", json.writeValueAsString(scene.stage().shapes().stream().map(Shape::name).toList()));
        attributes.put("lightning/materials", json.writeValueAsString(materialNames()));
        return attributes;
    }

    private List<String> materialNames() {
        List<String> names = new ArrayList<>();
        for (int m = 0; m < cache.geometry().materials().count(); m++) {
            Material material = cache.geometry().materials().material(m);
            names.add(material.name());
        }
        return names;
    }

    /** Returns the number of color layers, without the image. */
    public int layerCount() {
        return colorChannels.length - 1;
    }

    /** Returns the memory in bytes for writing, in addition to the cache. */
    public long bytesToWrite(int threads) {
        return (long) COPIES_PER_WORKER * threads * header.bytesPerLine() * Film.TILE_SIZE;
    }

    /**
     * Writes the file, atomically.
     *
     * @param memory maximum number of bytes to use
     * @throws IOException if it cannot be written, or needs more memory; the message is a sentence for the user
     * @throws java.util.concurrent.CancellationException if {@code progress} requested cancellation
     */
    public void write(Path file, long memory, WorkerPool workers, Progress progress) throws IOException {
        if (bytesToWrite(workers.count()) > memory || header.bytesPerLine() * ExrHeader.LINES_PER_CHUNK > Integer.MAX_VALUE / 2) {
            throw new IOException(String.format(java.util.Locale.ROOT,
                    "%d layers of %d x %d pixels need %.1f GB of memory to write, at most %.1f GB allowed", colorChannels.length,
                    film.width(), film.height(), bytesToWrite(workers.count()) / 1e9, Math.max(memory, 0) / 1e9));
        }
        try {
            AtomicFile.of(file).writeRandomAccess(channel -> {
                ExrWriter writer = new ExrWriter(channel, header);
                List<EngineWorkers<LayerCompositor>> painters =
                        EngineWorkers.perThread(workers.count(), engines, engine -> new LayerCompositor(cache, engine));
                workers.run(Math.ceilDiv(film.height(), Film.TILE_SIZE), (worker, row) -> writeRow(painters.get(worker), row, writer),
                        progress);
                writer.finish();
            });
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    /** Writes a row of tiles, two chunks. */
    private void writeRow(EngineWorkers<LayerCompositor> painters, int row, ExrWriter writer) {
        ExrChunk[] chunks = new ExrChunk[Math.min(Film.TILE_SIZE / ExrHeader.LINES_PER_CHUNK,
                header.chunkCount() - row * Film.TILE_SIZE / ExrHeader.LINES_PER_CHUNK)];
        for (int c = 0; c < chunks.length; c++) {
            chunks[c] = new ExrChunk(header, row * Film.TILE_SIZE / ExrHeader.LINES_PER_CHUNK + c);
        }
        for (int column = 0; column < film.tilesX(); column++) {
            int tile = row * film.tilesX() + column;
            writeTile(painters.forTile(tile), tile, SamplePositions.centers(column * Film.TILE_SIZE, row * Film.TILE_SIZE), chunks);
        }
        try {
            for (int c = 0; c < chunks.length; c++) {
                byte[] compressed = chunks[c].compress();
                chunks[c] = null;
                writer.writeChunk(row * Film.TILE_SIZE / ExrHeader.LINES_PER_CHUNK + c, compressed);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void writeTile(LayerCompositor painter, int tile, SamplePositions samplePositions, ExrChunk[] chunks) {
        float[][] picture = {film.red(tile), film.green(tile), film.blue(tile)};
        put(picture, colorChannels[0], samplePositions, chunks);
        LayerSum layerSum = new LayerSum(Film.TILE_PIXELS);
        for (int k = 0; k < layers.size(); k++) {
            float[][] layer = layerPixels(painter, layers.get(k), tile, samplePositions);
            layerSum.add(layer);
            put(layer, colorChannels[k + 1], samplePositions, chunks);
        }
        if (isExact) {
            put(layerSum.residual(picture), colorChannels[layers.size() + 1], samplePositions, chunks);
        }
        SurfaceChannels surfaces = new SurfaceChannels(cache);
        float[] values = new float[surfaceChannels.length];
        forEachPixel(samplePositions, (x, y, pixel) -> {
            surfaces.sample(x, y, values);
            for (int i = 0; i < surfaceChannels.length; i++) {
                chunk(chunks, y).put(surfaceChannels[i], x, y % ExrHeader.LINES_PER_CHUNK, values[i]);
            }
        });
    }

    /** Returns the pixels of a layer's tile, averaged over samples if it has several. */
    private float[][] layerPixels(LayerCompositor painter, Layer layer, int tile, SamplePositions samplePositions) {
        CachedTile center = cache.tileCount() == 0 ? null : composeLayer(painter, layer, cache.tile(tile), samplePositions);
        return cache.fineCount() == 0 ? center.film : cache.fineTile(tile)
                .map(center, samplePositions, (at, block) -> composeLayer(painter, layer, block, at))
                .film();
    }

    private static CachedTile composeLayer(LayerCompositor painter, Layer layer, CachedTile tile, SamplePositions samplePositions) {
        return new CachedTile(tile.levels, tile.hitShapes, tile.images, painter.colors(layer, tile, samplePositions), tile.edges);
    }

    private void put(float[][] values, int[] channels, SamplePositions samplePositions, ExrChunk[] chunks) {
        forEachPixel(samplePositions, (x, y, pixel) -> {
            for (int c = 0; c < 3; c++) {
                chunk(chunks, y).put(channels[c], x, y % ExrHeader.LINES_PER_CHUNK, values[c][pixel]);
            }
        });
    }

    private static ExrChunk chunk(ExrChunk[] chunks, int y) {
        return chunks[y % Film.TILE_SIZE / ExrHeader.LINES_PER_CHUNK];
    }

    private interface PixelVisitor {
        void visit(int x, int y, int pixel);
    }

    private void forEachPixel(SamplePositions samplePositions, PixelVisitor visitor) {
        int right = Math.min(samplePositions.x0() + Film.TILE_SIZE, film.width());
        int bottom = Math.min(samplePositions.y0() + Film.TILE_SIZE, film.height());
        for (int y = samplePositions.y0(); y < bottom; y++) {
            for (int x = samplePositions.x0(); x < right; x++) {
                visitor.visit(x, y, Film.pixelInTile(x, y));
            }
        }
    }
}
