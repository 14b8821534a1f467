package lightning.render.cache;

import java.io.IOException;
import java.lang.foreign.Arena;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Path;
import java.util.List;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;

/**
 * Picture with all that was computed for it in one file, which another process can continue from. It contains what does not follow from
 * the scene, which the reader must have: rows and colors as {@link CacheSerializer} writes them, and then the lengths of both.
 */
public final class PictureFile {
    private static final ValueLayout.OfLong LONG = ValueLayout.JAVA_LONG_UNALIGNED.withOrder(ByteOrder.LITTLE_ENDIAN);
    private static final int LENGTHS = 2 * Long.BYTES;

    private PictureFile() {}

    /**
     * Returns whether a picture of accuracy exact can be written: mirrors show the same scene, and rows and paths refer to materials and
     * objects as they do after a first pass.
     */
    public static boolean canWrite(PixelCache cache) {
        return cache.hasSameIndirectInMirrors() && cache.geometry().hasFirstMaterialIndices()
                && CacheMetadata.Paths.areSame(CacheMetadata.Paths.of(cache.indirect()),
                        CacheMetadata.Paths.ofScene(cache.geometry(), cache.scene()));
    }

    /**
     * Writes a picture.
     *
     * @throws IOException if the channel throws
     */
    public static void write(PixelCache cache, SeekableByteChannel out) throws IOException {
        CacheSerializer.writeRows(cache, new ColumnWriter(out));
        long rows = out.position();
        CacheSerializer.writeColors(cache, new ColumnWriter(out));
        long colors = out.position() - rows;
        ByteBuffer lengths = ByteBuffer.allocate(LENGTHS).order(ByteOrder.LITTLE_ENDIAN).putLong(rows).putLong(colors).flip();
        while (lengths.hasRemaining()) {
            out.write(lengths);
        }
    }

    /**
     * Reads the picture of a scene.
     *
     * @param geometry of the scene
     * @param scene    scene whose picture was written, with equal values
     * @throws IOException if the file cannot be read or is damaged
     */
    public static PixelCache read(Path file, Geometry geometry, Scene scene) throws IOException {
        try (Arena arena = Arena.ofConfined(); FileChannel channel = FileChannel.open(file)) {
            return read(channel.map(FileChannel.MapMode.READ_ONLY, 0, channel.size(), arena), CacheMetadata.ofScene(geometry, scene));
        } catch (InternalError e) {
            // The disk failed to read a page of the mapping.
            throw new IOException(e.getMessage(), e);
        }
    }

    private static PixelCache read(MemorySegment in, CacheMetadata metadata) throws IOException {
        long end = in.byteSize() - LENGTHS;
        long rows = end < 0 ? -1 : in.get(LONG, end);
        long colors = end < 0 ? -1 : in.get(LONG, end + Long.BYTES);
        if (rows < 0 || colors < 0 || rows > end || colors != end - rows) {
            throw new IOException(
                    "expected two lengths at the end of the file, with the sum " + end + ", found " + rows + " and " + colors);
        }
        PixelCache read = CacheSerializer.read(metadata, new ColumnReader(in.asSlice(0, rows)), new ColumnReader(in.asSlice(rows, colors)));
        removeLayersWithoutStamp(read, metadata.lights());
        return read;
    }

    /** Removes layers of lights that are off: they may show an older scene. The arrays are new, so they may be written. */
    private static void removeLayersWithoutStamp(PixelCache read, List<CachedLight> lights) {
        for (CachedTile tile : read.allTiles()) {
            for (TileLevel level : tile.levels) {
                removeLayers(level, lights);
            }
        }
        IndirectCache indirect = read.indirect();
        for (TileLevel block : indirect == null ? new TileLevel[0] : indirect.surfels()) {
            removeLayers(block, lights);
        }
    }

    private static void removeLayers(TileLevel level, List<CachedLight> lights) {
        for (CachedLight light : lights) {
            // Surfels that no light was computed for have no layers at all.
            if (light.stamp() == null && light.index() < level.layers().length) {
                level.layers()[light.index()] = null;
            }
        }
    }
}
