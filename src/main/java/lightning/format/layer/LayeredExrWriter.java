package lightning.format.layer;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.base.file.AtomicFile;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.exr.ExrAttribute;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrChunk;
import lightning.format.exr.ExrHeader;
import lightning.format.exr.ExrType;
import lightning.format.exr.ExrWriter;
import lightning.render.cache.PixelCache;
import lightning.render.engine.EngineChoice;
import lightning.render.engine.EngineWorkers;
import lightning.render.image.Film;
import lightning.render.trace.SamplePositions;
import org.jspecify.annotations.Nullable;

/**
 * Writer for an image with its layers, mattes and header in one OpenEXR file, one row of tiles at a time. Channels R, G and B are
 * the image.
 */
public final class LayeredExrWriter {
    /** Copies of a row of tiles per worker: raw, shuffled, compressed, and compressed while queued. */
    private static final int COPIES_PER_WORKER = 4;

    private final EngineChoice engines;
    private final Film film;
    private final List<ChannelSource> sources = new ArrayList<>();
    private final ExrHeader header;
    /** Channel indices of each source. */
    private final List<int[]> indices;
    private final int layerCount;
    private final long preparedBytes;
    /** Mattes; null if there are none. */
    private final @Nullable MatteChannels mattes;

    /**
     * Creates a writer.
     *
     * @param cache cache of a finished image
     * @param frame time of the image in its shot; empty if it is not part of one
     */
    public LayeredExrWriter(PixelCache cache, EngineChoice engines, ExrContent content, Optional<FrameTime> frame) {
        this.engines = engines;
        film = cache.film();
        sources.add(new FilmChannels(film, content.type(), content.primaries()));
        if (content.layers() != ExrContent.Layers.NONE) {
            LayerChannels layers =
                    new LayerChannels(cache, engines, content.type(), content.primaries(), content.layers() == ExrContent.Layers.ALL,
                            content.grouped());
            sources.add(layers);
            sources.add(new SurfaceChannels(cache, content.type()));
            layerCount = layers.layerNames().size();
            preparedBytes = layers.preparedBytes();
        } else {
            layerCount = 0;
            preparedBytes = 0;
        }
        mattes = content.matteLevels() == 0 ? null : new MatteChannels(cache, content.matteLevels());
        if (mattes != null) {
            sources.add(mattes);
        }
        Map<String, ExrAttribute> attributes = new LinkedHashMap<>(SceneMetadata.of(cache.scene(), frame));
        attributes.putAll(content.primaries().attributes());
        sources.forEach(source -> attributes.putAll(source.attributes()));
        header = new ExrHeader(film.width(), film.height(), sources.stream().flatMap(source -> source.channels().stream()).toList(),
                attributes);
        List<String> names = header.channels().stream().map(ExrChannel::name).toList();
        indices = sources.stream().map(source -> source.channels().stream().mapToInt(c -> names.indexOf(c.name())).toArray()).toList();
    }

    /**
     * Creates a writer for an image with its layers.
     *
     * @param cache cache of a finished image
     * @param type type of colors and normals, HALF or FLOAT; a file of halves has no residual layer
     */
    public LayeredExrWriter(PixelCache cache, EngineChoice engines, ExrType type) {
        this(cache, engines, ExrContent.layers(type), Optional.empty());
    }

    /** Returns the number of color layers, without the image. */
    public int layerCount() {
        return layerCount;
    }

    /** Returns the number of pixels, of those written, that show more objects or materials than the file has levels. */
    public int crowdedPixels() {
        return mattes == null ? 0 : mattes.crowdedPixels();
    }

    /** Returns the largest number of objects or materials of a written pixel. */
    public int maxIds() {
        return mattes == null ? 0 : mattes.maxIds();
    }

    /** Returns the memory in bytes for writing, in addition to the cache. */
    public long bytesToWrite(int threads) {
        return (long) COPIES_PER_WORKER * threads * header.bytesPerLine() * Film.TILE_SIZE + preparedBytes;
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
                    "%d channels of %d x %d pixels need %.1f GB of memory to write, at most %.1f GB allowed", header.channels().size(),
                    film.width(), film.height(), bytesToWrite(workers.count()) / 1e9, Math.max(memory, 0) / 1e9));
        }
        try {
            sources.forEach(source -> source.prepare(workers, progress.cancellationOnly()));
            AtomicFile.of(file).writeRandomAccess(channel -> {
                ExrWriter writer = new ExrWriter(channel, header);
                List<EngineWorkers<List<ChannelSource.TileWriter>>> writers = EngineWorkers.perThread(workers.count(), engines,
                        engine -> sources.stream().map(source -> source.writer(engine)).toList());
                workers.run(Math.ceilDiv(film.height(), Film.TILE_SIZE), (worker, row) -> writeRow(writers.get(worker), row, writer),
                        progress);
                writer.finish();
            });
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    /** Writes a row of tiles, two chunks. */
    private void writeRow(EngineWorkers<List<ChannelSource.TileWriter>> writers, int row, ExrWriter writer) {
        ExrChunk[] chunks = new ExrChunk[Math.min(Film.TILE_SIZE / ExrHeader.LINES_PER_CHUNK,
                header.chunkCount() - row * Film.TILE_SIZE / ExrHeader.LINES_PER_CHUNK)];
        for (int c = 0; c < chunks.length; c++) {
            chunks[c] = new ExrChunk(header, row * Film.TILE_SIZE / ExrHeader.LINES_PER_CHUNK + c);
        }
        for (int column = 0; column < film.tilesX(); column++) {
            int tile = row * film.tilesX() + column;
            SamplePositions centers = SamplePositions.centers(column * Film.TILE_SIZE, row * Film.TILE_SIZE);
            List<ChannelSource.TileWriter> tileWriters = writers.forTile(tile);
            for (int i = 0; i < tileWriters.size(); i++) {
                tileWriters.get(i).write(tile, centers, new TileSink(header.width(), header.height(), centers, indices.get(i),
                        (channel, x, y, value) -> chunks[y % Film.TILE_SIZE / ExrHeader.LINES_PER_CHUNK].put(channel, x,
                                y % ExrHeader.LINES_PER_CHUNK, value)));
            }
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
}
