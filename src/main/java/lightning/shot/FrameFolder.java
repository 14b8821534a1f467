package lightning.shot;

import java.io.IOException;
import java.lang.foreign.Arena;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import lightning.base.file.ScratchFolder;
import lightning.base.text.Texts;
import lightning.render.cache.CacheColumns;
import lightning.render.cache.CacheOutline;
import lightning.render.cache.PixelCache;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;

/**
 * The rows and colours of frames as files, mapped for reading. A file is never written twice; what is damaged, or could not be written,
 * is as if it were not there. Any thread may call.
 */
final class FrameFolder implements AutoCloseable {
    private final ScratchFolder folder;
    private final long room;
    private final AtomicLong bytes = new AtomicLong();
    private final AtomicLong files = new AtomicLong();
    private final AtomicReference<String> problem = new AtomicReference<>();

    /** A file that was written. */
    record Part(Path file, long bytes) {}

    /** What writes columns. */
    @FunctionalInterface
    private interface Columns {
        void write(PixelCache cache, ColumnWriter out) throws IOException;
    }

    /**
     * @param place where the folder of these files is made
     * @param room  bytes that all files may take
     * @throws IOException if it cannot be made
     */
    FrameFolder(Path place, long room) throws IOException {
        folder = ScratchFolder.in(place);
        this.room = room;
    }

    /** Bytes that files may still take. */
    long room() {
        return Math.max(0, room - bytes.get());
    }

    /** Writes rows, layers and codes; null where there is no room, or that fails. */
    Part writeRows(PixelCache cache) {
        return write("rows-", cache, CacheColumns::writeRows);
    }

    /** Writes the colours likewise. */
    Part writeColors(PixelCache cache) {
        return write("colors-", cache, CacheColumns::writeColors);
    }

    private Part write(String name, PixelCache cache, Columns columns) {
        if (bytes.get() >= room) {
            tell(Texts.of("the frames took all of the disk's room that they may take"));
            return null;
        }
        Path file = folder.file(name + files.incrementAndGet());
        try {
            folder.write(file, channel -> columns.write(cache, new ColumnWriter(channel)));
            Part part = new Part(file, Files.size(file));
            bytes.addAndGet(part.bytes);
            return part;
        } catch (IOException e) {
            tell(Texts.of("frames could not be written to disk: {0}", e.getMessage()));
            return null;
        }
    }

    /**
     * The picture of two files.
     *
     * @throws IOException if they are not as they were written
     */
    PixelCache read(CacheOutline outline, Part rows, Part colors) throws IOException {
        try (Arena arena = Arena.ofConfined()) {
            return CacheColumns.read(outline, reader(rows, arena), reader(colors, arena));
        } catch (InternalError e) {
            // A page that the disk does not give.
            throw new IOException(e.getMessage(), e);
        }
    }

    private static ColumnReader reader(Part part, Arena arena) throws IOException {
        try (FileChannel channel = FileChannel.open(part.file)) {
            if (channel.size() != part.bytes) {
                throw new IOException("it has " + channel.size() + " bytes in place of " + part.bytes);
            }
            return new ColumnReader(channel.map(FileChannel.MapMode.READ_ONLY, 0, part.bytes, arena));
        }
    }

    /** Removes a file; null is none. */
    void remove(Part part) {
        if (part == null) {
            return;
        }
        try {
            Files.deleteIfExists(part.file);
        } catch (IOException e) {
            // It goes with the folder.
        }
        bytes.addAndGet(-part.bytes);
    }

    /** Something went wrong, in a sentence without its full stop. */
    void tell(String sentence) {
        problem.compareAndSet(null, sentence);
    }

    /** What went wrong first; null for nothing. */
    String problem() {
        return problem.get();
    }

    @Override
    public void close() {
        folder.close();
    }
}
