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
import java.util.ArrayList;
import java.util.List;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;

/**
 * Picture with all that was computed for it in one file, which another process can continue from. It contains what does not follow from
 * the scene, which the reader must have: rows and colors as {@link CacheSerializer} writes them, the order of the materials' indices, and then
 * the lengths of all three.
 */
public final class PictureFile {
    private static final ValueLayout.OfLong LONG = ValueLayout.JAVA_LONG_UNALIGNED.withOrder(ByteOrder.LITTLE_ENDIAN);
    private static final int LENGTHS = 3 * Long.BYTES;

    private PictureFile() {}

    /**
     * Returns whether a picture of accuracy exact can be written: mirrors show the same scene, which has all materials that rows refer
     * to, and paths refer to objects as they do after a first pass.
     */
    public static boolean canWrite(PixelCache cache) {
        return cache.hasSameIndirectInMirrors() && cache.geometry().materialNames().isPresent()
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
        writeNames(cache.geometry().materialNames().orElseThrow(), new ColumnWriter(out));
        long names = out.position() - rows - colors;
        ByteBuffer lengths =
                ByteBuffer.allocate(LENGTHS).order(ByteOrder.LITTLE_ENDIAN).putLong(rows).putLong(colors).putLong(names).flip();
        while (lengths.hasRemaining()) {
            out.write(lengths);
        }
    }

    private static void writeNames(List<String> names, ColumnWriter out) throws IOException {
        out.writeInt(names.size());
        for (String name : names) {
            out.writeArray(name.toCharArray());
        }
        out.writeChecksum();
    }

    private static List<String> readNames(ColumnReader in) throws IOException {
        List<String> names = new ArrayList<>();
        for (int i = in.readCount(); i > 0; i--) {
            names.add(new String(in.readChars()));
        }
        in.expectEnd();
        return names;
    }

    /**
     * Reads the picture of a scene.
     *
     * @param geometry of the scene, with any order of materials
     * @param scene    scene whose picture was written, with equal values
     * @throws IOException if the file cannot be read or is damaged
     * @throws IllegalArgumentException if the scene has other materials
     */
    public static PixelCache read(Path file, Geometry geometry, Scene scene) throws IOException {
        try (Arena arena = Arena.ofConfined(); FileChannel channel = FileChannel.open(file)) {
            return read(channel.map(FileChannel.MapMode.READ_ONLY, 0, channel.size(), arena), geometry, scene);
        } catch (InternalError e) {
            // The disk failed to read a page of the mapping.
            throw new IOException(e.getMessage(), e);
        }
    }

    private static PixelCache read(MemorySegment in, Geometry geometry, Scene scene) throws IOException {
        long end = in.byteSize() - LENGTHS;
        long rows = end < 0 ? -1 : in.get(LONG, end);
        long colors = end < 0 ? -1 : in.get(LONG, end + Long.BYTES);
        long names = end < 0 ? -1 : in.get(LONG, end + 2 * Long.BYTES);
        if (rows < 0 || colors < 0 || names < 0 || rows > end || colors > end - rows || names != end - rows - colors) {
            throw new IOException("expected three lengths at the end of the file, with the sum " + end + ", found " + rows + ", " + colors
                    + " and " + names);
        }
        CacheMetadata metadata =
                CacheMetadata.ofScene(geometry.withMaterialNames(readNames(new ColumnReader(in.asSlice(rows + colors, names)))), scene);
        PixelCache read = CacheSerializer.read(metadata, new ColumnReader(in.asSlice(0, rows)), new ColumnReader(in.asSlice(rows, colors)));
        removeLayersWithoutStamp(read, metadata.lights());
        return read;
    }

    /** Removes layers of lights that are off: they may show an older scene. The arrays are new, so they may be written. */
    private static void removeLayersWithoutStamp(PixelCache read, List<CachedLight> lights) {
        for (CachedTile tile : read.allTiles()) {
            for (TileLevel level : tile.levels()) {
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
