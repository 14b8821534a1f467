package lightning.layer;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import lightning.base.file.AtomicFile;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.exr.ExrAttribute;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrType;
import lightning.format.exr.ExrWindow;
import lightning.format.exr.ExrWriter;
import lightning.render.cache.PixelCache;
import lightning.render.engine.EngineChoice;
import lightning.render.engine.EngineWorkers;
import lightning.render.image.Film;
import lightning.render.trace.SamplePositions;
import org.jspecify.annotations.Nullable;

/**
 * Writer for an image with its layers, mattes and header in one OpenEXR file, some lines at a time. Channels R, G and B are
 * the image.
 */
public final class LayeredExrWriter {
    /** Copies of some lines per worker: raw, shuffled, compressed, and compressed while queued. */
    private static final int COPIES_PER_WORKER = 4;

    private final EngineChoice engines;
    private final Film film;
    private final List<ChannelSource> sources = new ArrayList<>();
    private final ImageCrop crop;
    private final LayerParts parts;
    /** Places of all channels, those of the first source first. */
    private final LayerParts.Slot[] slots;
    /** Indices of each source's channels in {@link #slots}. */
    private final List<int[]> indices = new ArrayList<>();
    private final int layerCount;
    /** Mattes; null if there are none. */
    private final @Nullable MatteChannels mattes;
    private boolean isPrepared;

    /**
     * Creates a writer.
     *
     * @param cache cache of a finished image
     * @param layout storage; its crop must be inside the image
     * @param frame frame of the image in its shot, for motion vectors; empty if it is not part of one
     */
    public LayeredExrWriter(PixelCache cache, EngineChoice engines, ExrContent content, ExrLayout layout, Optional<ShotFrame> frame) {
        this.engines = engines;
        film = cache.film();
        crop = layout.crop().orElse(new ImageCrop(0, 0, film.width(), film.height()));
        sources.add(new FilmChannels(film, content.type(), content.primaries()));
        if (content.layers() != ExrContent.Layers.NONE) {
            LayerChannels layers =
                    new LayerChannels(cache, engines, content.type(), content.primaries(), content.layers() == ExrContent.Layers.ALL,
                            content.grouped());
            sources.add(new FilteredChannels(cache, content.type()));
            sources.add(layers);
            sources.add(new SurfaceChannels(cache, content.type(), frame));
            layerCount = layers.layerNames().size();
        } else {
            layerCount = 0;
        }
        mattes = content.matteLevels() == 0 ? null : new MatteChannels(cache, content.matteLevels());
        if (mattes != null) {
            sources.add(mattes);
        }
        Map<String, ExrAttribute> common = new LinkedHashMap<>(SceneMetadata.of(cache.scene(), frame.map(ShotFrame::time)));
        common.putAll(content.primaries().attributes());
        Map<String, ExrAttribute> others = new LinkedHashMap<>();
        sources.forEach(source -> others.putAll(source.attributes()));
        List<ExrChannel> channels = sources.stream().flatMap(source -> source.channels().stream()).toList();
        parts = LayerParts.of(channels, common, others, layout, crop, new ExrWindow(crop.left(), crop.top(), film.width(), film.height()));
        slots = channels.stream().map(parts::slot).toArray(LayerParts.Slot[]::new);
        int first = 0;
        for (ChannelSource source : sources) {
            int end = first + source.channels().size();
            indices.add(IntStream.range(first, end).toArray());
            first = end;
        }
    }

    /**
     * Creates a writer for an image with its layers.
     *
     * @param cache cache of a finished image
     * @param type type of colors and normals, HALF or FLOAT; a file of halves has no residual layer
     */
    public LayeredExrWriter(PixelCache cache, EngineChoice engines, ExrType type) {
        this(cache, engines, ExrContent.layers(type), ExrLayout.DEFAULT, Optional.empty());
    }

    /** Returns the number of color layers, without the image. */
    public int layerCount() {
        return layerCount;
    }

    /** Returns the number of channels. */
    public int channelCount() {
        return slots.length;
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
        return (long) COPIES_PER_WORKER * threads * parts.bytesPerLine() * LayerBand.LINES;
    }

    /** Returns the bytes of all pixels before compression. */
    public long uncompressedBytes() {
        return parts.bytesPerLine() * crop.height();
    }

    private void checkMemory(long memory, WorkerPool workers) throws IOException {
        boolean fits = parts.headers().stream().allMatch(h -> h.bytesPerLine() * h.compression().lines() <= Integer.MAX_VALUE / 2);
        if (bytesToWrite(workers.count()) > memory || !fits) {
            throw new IOException(String.format(java.util.Locale.ROOT,
                    "%d channels of %d x %d pixels need %.1f GB of memory to write, at most %.1f GB allowed", channelCount(),
                    film.width(), film.height(), bytesToWrite(workers.count()) / 1e9, Math.max(memory, 0) / 1e9));
        }
    }

    private void prepare(WorkerPool workers, Progress progress) {
        if (!isPrepared) {
            sources.forEach(source -> source.prepare(workers, progress.cancellationOnly()));
            isPrepared = true;
        }
    }

    private List<EngineWorkers<List<ChannelSource.TileWriter>>> tileWriters(int threads) {
        return EngineWorkers.perThread(threads, engines, engine -> sources.stream().map(source -> source.writer(engine)).toList());
    }

    /**
     * Estimates size and time of a file from two groups of lines, which it compresses. Other lines may be simpler or richer.
     *
     * @throws IOException if it needs more memory; the message is a sentence for the user
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public WriteEstimate estimate(long memory, WorkerPool workers, Progress progress) throws IOException {
        checkMemory(memory, workers);
        prepare(workers, progress);
        // Rendering may have been canceled, and then tiles are incomplete.
        progress.checkCanceled("canceled while it was prepared");
        int bands = LayerBand.count(crop);
        var writers = tileWriters(1).getFirst();
        long bytes = compressedBytes(writers, bands / 3);
        // The first lines also compile the code: their time says little.
        long start = System.nanoTime();
        bytes += compressedBytes(writers, 2 * bands / 3);
        double seconds = (System.nanoTime() - start) / 1e9;
        if (mattes != null) {
            mattes.clearCounts();
        }
        return new WriteEstimate(bytes * bands / 2, bytesToWrite(workers.count()), seconds * Math.ceilDiv(bands, workers.count()));
    }

    private long compressedBytes(EngineWorkers<List<ChannelSource.TileWriter>> writers, int band) {
        return compress(writers, band).stream().mapToLong(chunk -> chunk.compressed().length).sum();
    }

    /**
     * Writes the file, atomically.
     *
     * @param memory maximum number of bytes to use
     * @throws IOException if it cannot be written, or needs more memory; the message is a sentence for the user
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public void write(Path file, long memory, WorkerPool workers, Progress progress) throws IOException {
        checkMemory(memory, workers);
        try {
            prepare(workers, progress);
            AtomicFile.of(file).writeRandomAccess(channel -> {
                ExrWriter writer = new ExrWriter(channel, parts.headers());
                List<EngineWorkers<List<ChannelSource.TileWriter>>> writers = tileWriters(workers.count());
                workers.run(LayerBand.count(crop), (worker, band) -> {
                    try {
                        writer.writeChunks(band, compress(writers.get(worker), band));
                    } catch (IOException e) {
                        throw new UncheckedIOException(e);
                    }
                }, progress);
                writer.finish();
            });
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    /** Returns the chunks of some lines. Lines of a crop may belong to two rows of tiles, each of which is then composed twice. */
    private List<ExrWriter.Chunk> compress(EngineWorkers<List<ChannelSource.TileWriter>> writers, int number) {
        LayerBand band = new LayerBand(number, parts, crop);
        ImageCrop area = band.area();
        for (int row = area.top() / Film.TILE_SIZE; row * Film.TILE_SIZE < area.bottom(); row++) {
            for (int column = area.left() / Film.TILE_SIZE; column * Film.TILE_SIZE < area.right(); column++) {
                int tile = row * film.tilesX() + column;
                SamplePositions centers = SamplePositions.centers(column * Film.TILE_SIZE, row * Film.TILE_SIZE);
                List<ChannelSource.TileWriter> tileWriters = writers.forTile(tile);
                for (int i = 0; i < tileWriters.size(); i++) {
                    tileWriters.get(i).write(tile, centers, new TileSink(area, centers, indices.get(i),
                            (channel, x, y, value) -> band.put(slots[channel], x, y, value)));
                }
            }
        }
        return band.compress();
    }
}
