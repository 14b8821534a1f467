package lightning.render.cache;

import java.io.IOException;
import java.util.Arrays;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.shading.BounceImages;
import lightning.render.shading.EdgeColors;
import lightning.render.shading.LightLayer;
import lightning.render.shading.LightRows;
import lightning.render.trace.HitRows;
import lightning.render.trace.SampleCells;

/**
 * Serializer of a cached image's columns, in two parts: rows, layers and edge colors, which edits of weights do not change; and
 * colors, which nearly every edit changes. For images of accuracy exact without indirect light.
 */
public final class CacheSerializer {
    private CacheSerializer() {}

    public static void writeRows(PixelCache cache, ColumnWriter out) throws IOException {
        out.writeInt(cache.tileCount());
        for (CachedTile tile : cache.tiles()) {
            write(tile, out);
        }
        out.writeInt(cache.fineCount());
        for (int i = 0; i < cache.fineCount(); i++) {
            for (FineSamples samples : cache.fineTile(i).stages()) {
                write(samples, out);
            }
        }
        out.writeChecksum();
    }

    private static void write(FineSamples samples, ColumnWriter out) throws IOException {
        out.writeInt(samples.cells().grid());
        out.writeArray(samples.cells().cells());
        out.writeArray(samples.pixels());
        out.writeInt(samples.blocks().length);
        for (SampleBlock block : samples.blocks()) {
            out.writeArray(block.pixels());
            write(block.rows(), out);
        }
    }

    private static void write(CachedTile tile, ColumnWriter out) throws IOException {
        out.writeInt(tile.levels.length);
        for (TileLevel level : tile.levels) {
            level.rows().writeTo(out);
            out.writeInt(level.layers().length);
            for (LightLayer layer : level.layers()) {
                out.writeInt(layer == null ? 0 : 1);
                if (layer != null) {
                    ((LightRows) layer).writeTo(out);
                }
            }
        }
        out.writeInt(tile.hitShapes.length);
        for (int[] shapes : tile.hitShapes) {
            out.writeArray(shapes);
        }
        out.writeInt(tile.edges == null ? 0 : 1);
        if (tile.edges != null) {
            out.writeArray(tile.edges.colors());
            write(tile.edges.images(), out);
        }
    }

    public static void writeColors(PixelCache cache, ColumnWriter out) throws IOException {
        for (CachedTile tile : cache.tiles()) {
            writeColors(tile, out);
        }
        for (int i = 0; i < cache.fineCount(); i++) {
            for (SampleBlock block : cache.fineTile(i).blocks().toList()) {
                writeColors(block.rows(), out);
                out.writeFloatArrays(block.means());
            }
            out.writeFloatArrays(cache.fineTile(i).film());
        }
        out.writeChecksum();
    }

    private static void writeColors(CachedTile tile, ColumnWriter out) throws IOException {
        out.writeFloatArrays(tile.film);
        write(tile.images, out);
    }

    private static void write(BounceImages images, ColumnWriter out) throws IOException {
        out.writeFloatArrays(images == null ? null : images.mirrored());
        out.writeFloatArrays(images == null ? null : images.refracted());
    }

    /** Reads the image of these columns. */
    public static PixelCache read(CacheMetadata outline, ColumnReader rows, ColumnReader colors) throws IOException {
        CachedTile[] tiles = new CachedTile[rows.readCount()];
        for (int i = 0; i < tiles.length; i++) {
            tiles[i] = readTile(rows);
        }
        FineTile[] fine = new FineTile[rows.readCount()];
        for (int i = 0; i < fine.length; i++) {
            fine[i] = new FineTile(readSamples(rows), readSamples(rows), null);
        }
        rows.expectEnd();
        for (int i = 0; i < tiles.length; i++) {
            tiles[i] = withColors(tiles[i], colors);
        }
        for (int i = 0; i < fine.length; i++) {
            fine[i] = new FineTile(withColors(fine[i].first(), colors), withColors(fine[i].rest(), colors), colors.readFloatArrays());
        }
        colors.expectEnd();
        return new PixelCache(outline.geometry(), tiles, fine, outline.scenes(), outline.lights(), outline.mirroredLights(), null,
                null);
    }

    private static FineSamples readSamples(ColumnReader in) throws IOException {
        SampleCells cells = new SampleCells(in.readInt(), in.readInts());
        short[] pixels = in.readShorts();
        SampleBlock[] blocks = new SampleBlock[in.readCount()];
        for (int b = 0; b < blocks.length; b++) {
            blocks[b] = new SampleBlock(in.readShorts(), readTile(in), null);
        }
        return new FineSamples(cells, pixels, blocks);
    }

    private static CachedTile readTile(ColumnReader in) throws IOException {
        TileLevel[] levels = new TileLevel[in.readCount()];
        for (int l = 0; l < levels.length; l++) {
            HitRows rows = HitRows.readFrom(in);
            LightLayer[] layers = new LightLayer[in.readCount()];
            for (int i = 0; i < layers.length; i++) {
                layers[i] = in.readInt() == 0 ? null : LightRows.readFrom(in);
            }
            levels[l] = new TileLevel(rows, layers);
        }
        int[][] hitShapes = new int[in.readCount()][];
        for (int i = 0; i < hitShapes.length; i++) {
            hitShapes[i] = in.readInts();
        }
        EdgeColors edges = in.readInt() == 0 ? null : new EdgeColors(in.readInts(), readImages(in));
        return new CachedTile(levels, hitShapes, null, null, edges);
    }

    private static FineSamples withColors(FineSamples samples, ColumnReader in) throws IOException {
        SampleBlock[] blocks = new SampleBlock[samples.blocks().length];
        for (int b = 0; b < blocks.length; b++) {
            SampleBlock block = samples.blocks()[b];
            blocks[b] = new SampleBlock(block.pixels(), withColors(block.rows(), in), in.readFloatArrays());
        }
        return new FineSamples(samples.cells(), samples.pixels(), blocks);
    }

    private static CachedTile withColors(CachedTile tile, ColumnReader in) throws IOException {
        float[][] film = in.readFloatArrays();
        return new CachedTile(tile.levels, tile.hitShapes, readImages(in), film, tile.edges);
    }

    private static BounceImages readImages(ColumnReader in) throws IOException {
        float[][] mirrored = in.readFloatArrays();
        float[][] refracted = in.readFloatArrays();
        return mirrored == null ? null : new BounceImages(mirrored, refracted);
    }

    /** Returns true if two images share the same rows, layers and edge colors, and differ at most in colors. */
    public static boolean hasSameRows(PixelCache a, PixelCache b) {
        if (a.tileCount() != b.tileCount() || a.fineCount() != b.fineCount()) {
            return false;
        }
        for (int i = 0; i < a.tileCount(); i++) {
            if (!hasSameRows(a.tile(i), b.tile(i))) {
                return false;
            }
        }
        for (int i = 0; i < a.fineCount(); i++) {
            if (!hasSameRows(a.fineTile(i).first(), b.fineTile(i).first()) || !hasSameRows(a.fineTile(i).rest(), b.fineTile(i).rest())) {
                return false;
            }
        }
        return true;
    }

    private static boolean hasSameRows(FineSamples a, FineSamples b) {
        boolean same = a.pixels() == b.pixels() && a.blocks().length == b.blocks().length;
        for (int i = 0; same && i < a.blocks().length; i++) {
            same = a.blocks()[i].pixels() == b.blocks()[i].pixels() && hasSameRows(a.blocks()[i].rows(), b.blocks()[i].rows());
        }
        return same;
    }

    private static boolean hasSameRows(CachedTile a, CachedTile b) {
        boolean same = a.levels.length == b.levels.length && Arrays.deepEquals(a.hitShapes, b.hitShapes) && a.edges == b.edges;
        for (int l = 0; same && l < a.levels.length; l++) {
            LightLayer[] before = a.levels[l].layers();
            LightLayer[] after = b.levels[l].layers();
            same = a.levels[l].rows() == b.levels[l].rows() && before.length == after.length;
            for (int i = 0; same && i < before.length; i++) {
                same = before[i] == after[i];
            }
        }
        return same;
    }
}
