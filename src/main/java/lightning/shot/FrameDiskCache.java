package lightning.shot;

import java.io.IOException;
import java.lang.foreign.Arena;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import lightning.base.file.ScratchFolder;
import lightning.base.text.Messages;
import lightning.render.cache.CacheMetadata;
import lightning.render.cache.CacheSerializer;
import lightning.render.cache.PixelCache;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import org.jspecify.annotations.Nullable;

/**
 * Disk cache for the rows and colors of frames, in memory-mapped files. Writes each file once; a damaged or failed file counts as missing.
 * Thread-safe.
 */
final class FrameDiskCache implements AutoCloseable {
    private final ScratchFolder folder;
    private final long maxBytes;
    private final AtomicLong usedBytes = new AtomicLong();
    private final AtomicLong fileCount = new AtomicLong();
    private final AtomicReference<String> problem = new AtomicReference<>();

    /** A written file. */
    record CacheFile(Path file, long bytes) {}

    /** Writer of cache columns. */
    @FunctionalInterface
    private interface ColumnsWriter {
        void write(PixelCache cache, ColumnWriter out) throws IOException;
    }

    /**
     * @param parent   parent of the folder for these files
     * @param maxBytes maximum bytes of all files
     * @throws IOException if the folder cannot be created
     */
    FrameDiskCache(Path parent, long maxBytes) throws IOException {
        folder = ScratchFolder.createIn(parent);
        this.maxBytes = maxBytes;
    }

    /** Returns the bytes still available. */
    long freeBytes() {
        return Math.max(0, maxBytes - usedBytes.get());
    }

    /** Writes rows, layers and codes; returns null without space or on failure. */
    @Nullable
    CacheFile writeRows(PixelCache cache) {
        return write("rows-", cache, CacheSerializer::writeRows);
    }

    /** Writes the colors; returns null without space or on failure. */
    @Nullable
    CacheFile writeColors(PixelCache cache) {
        return write("colors-", cache, CacheSerializer::writeColors);
    }

    private @Nullable CacheFile write(String name, PixelCache cache, ColumnsWriter columns) {
        if (usedBytes.get() >= maxBytes) {
            reportProblem(Messages.tr("the frame cache has reached its disk limit"));
            return null;
        }
        Path file = folder.file(name + fileCount.incrementAndGet());
        try {
            folder.write(file, channel -> columns.write(cache, new ColumnWriter(channel)));
            CacheFile cacheFile = new CacheFile(file, Files.size(file));
            usedBytes.addAndGet(cacheFile.bytes);
            return cacheFile;
        } catch (IOException e) {
            reportProblem(Messages.tr("cannot cache frames on disk: {0}", e.getMessage()));
            return null;
        }
    }

    /**
     * Reads a cache from two files.
     *
     * @throws IOException if they changed since they were written
     */
    PixelCache read(CacheMetadata outline, CacheFile rows, CacheFile colors) throws IOException {
        try (Arena arena = Arena.ofConfined()) {
            return CacheSerializer.read(outline, reader(rows, arena), reader(colors, arena));
        } catch (InternalError e) {
            // The disk failed to read a page of the mapping.
            throw new IOException(e.getMessage(), e);
        }
    }

    private static ColumnReader reader(CacheFile cacheFile, Arena arena) throws IOException {
        try (FileChannel channel = FileChannel.open(cacheFile.file)) {
            if (channel.size() != cacheFile.bytes) {
                throw new IOException("expected " + cacheFile.bytes + " bytes, found " + channel.size());
            }
            return new ColumnReader(channel.map(FileChannel.MapMode.READ_ONLY, 0, cacheFile.bytes, arena));
        }
    }

    /** Removes a file; null for none. */
    void remove(@Nullable CacheFile cacheFile) {
        if (cacheFile == null) {
            return;
        }
        try {
            Files.deleteIfExists(cacheFile.file);
        } catch (IOException e) {
            // It is removed with the folder.
        }
        usedBytes.addAndGet(-cacheFile.bytes);
    }

    /** Records a problem, in a sentence without its full stop. */
    void reportProblem(String message) {
        problem.compareAndSet(null, message);
    }

    /** Returns the first problem; null for none. */
    @Nullable
    String problem() {
        return problem.get();
    }

    @Override
    public void close() {
        folder.close();
    }
}
