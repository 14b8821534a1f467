package lightning.layer;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import lightning.base.file.SharedMemoryFile;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.exr.ExrAttribute;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrPrimaries;
import lightning.format.exr.ExrType;
import lightning.render.cache.PixelCache;
import lightning.render.engine.EngineChoice;
import lightning.render.engine.EngineWorkers;
import lightning.render.image.Film;
import lightning.render.trace.SamplePositions;

/**
 * An image with its layers as planes of 32-bit floats, one after the other: the channels and values of a layered OpenEXR file. Each plane has
 * the rows of one channel, the top row first.
 */
public final class LayerPlanes {
    private final EngineChoice engines;
    private final Film film;
    private final List<ChannelSource> sources;
    private final List<String> channels;

    /** @param cache cache of a finished image */
    public LayerPlanes(PixelCache cache, EngineChoice engines) {
        this.engines = engines;
        film = cache.film();
        sources = List.of(new FilmChannels(film, ExrType.FLOAT, ExrPrimaries.REC_709),
                new LayerChannels(cache, engines, ExrType.FLOAT, ExrPrimaries.REC_709, false, false),
                new SurfaceChannels(cache, ExrType.FLOAT, Optional.empty()));
        channels = sources.stream().flatMap(source -> source.channels().stream()).map(ExrChannel::name).toList();
    }

    /** Returns the names of all channels, in the order of their planes. */
    public List<String> channels() {
        return channels;
    }

    /** Returns the texts of a file's header that describe the channels, as JSON: names of layers, lights, shapes and materials. */
    public Map<String, String> descriptions() {
        Map<String, String> texts = new LinkedHashMap<>();
        sources.forEach(source -> source.attributes().forEach((name, attribute) -> {
            if (attribute instanceof ExrAttribute.Text(String text)) {
                texts.put(name, text);
            }
        }));
        return texts;
    }

    /** Returns the bytes of all planes. */
    public long bytes() {
        return channels.size() * planeBytes();
    }

    private long planeBytes() {
        return (long) film.width() * film.height() * Float.BYTES;
    }

    private long stripBytes() {
        return channels.size() * (long) Film.TILE_SIZE * film.width() * Float.BYTES;
    }

    /**
     * Writes all planes, little-endian.
     *
     * @param memory maximum number of bytes to use, without those of the file
     * @throws IOException if the file cannot be written, or it needs more memory; the message is a sentence for the user
     * @throws java.util.concurrent.CancellationException if {@code progress} requested cancellation; the planes are then incomplete
     */
    public void write(SharedMemoryFile file, long memory, WorkerPool workers, Progress progress) throws IOException {
        if (stripBytes() * workers.count() > memory || stripBytes() > Integer.MAX_VALUE) {
            throw new IOException(
                    String.format(Locale.ROOT, "%d channels of %d x %d pixels need %.1f GB of memory, at most %.1f GB allowed",
                            channels.size(), film.width(), film.height(), stripBytes() * workers.count() / 1e9, Math.max(memory, 0) / 1e9));
        }
        sources.forEach(source -> source.prepare(workers, progress.cancellationOnly()));
        List<EngineWorkers<List<ChannelSource.TileWriter>>> writers = EngineWorkers.perThread(workers.count(), engines,
                engine -> sources.stream().map(source -> source.writer(engine)).toList());
        try (SharedMemoryFile.Writer out = file.openWriter()) {
            workers.run(film.tilesY(), (worker, row) -> writeRow(writers.get(worker), row, out), progress);
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    /** Writes a row of tiles: a strip of each plane. */
    private void writeRow(EngineWorkers<List<ChannelSource.TileWriter>> writers, int row, SharedMemoryFile.Writer file) {
        int top = row * Film.TILE_SIZE;
        int lines = Math.min(Film.TILE_SIZE, film.height() - top);
        ByteBuffer strips = ByteBuffer.allocate(channels.size() * lines * film.width() * Float.BYTES).order(ByteOrder.LITTLE_ENDIAN);
        TileSink.Values values = (channel, x, y, value) -> strips
                .putFloat(((channel * lines + y - top) * film.width() + x) * Float.BYTES, value);
        for (int column = 0; column < film.tilesX(); column++) {
            int tile = row * film.tilesX() + column;
            SamplePositions centers = SamplePositions.centers(column * Film.TILE_SIZE, top);
            List<ChannelSource.TileWriter> tileWriters = writers.forTile(tile);
            int first = 0;
            for (int i = 0; i < tileWriters.size(); i++) {
                int count = sources.get(i).channels().size();
                tileWriters.get(i).write(tile, centers,
                        new TileSink(new ImageCrop(0, 0, film.width(), film.height()), centers,
                                IntStream.range(first, first + count).toArray(), values));
                first += count;
            }
        }
        int stripBytes = lines * film.width() * Float.BYTES;
        try {
            for (int channel = 0; channel < channels.size(); channel++) {
                file.write(strips.slice(channel * stripBytes, stripBytes),
                        channel * planeBytes() + (long) top * film.width() * Float.BYTES);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
