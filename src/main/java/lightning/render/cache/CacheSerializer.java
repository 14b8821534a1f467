package lightning.render.cache;

import java.io.IOException;
import java.util.Arrays;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.shading.BounceImages;
import lightning.render.shading.EdgeCodes;
import lightning.render.shading.LightLayer;
import lightning.render.shading.LightRows;
import lightning.render.trace.HitRows;

/**
 * Serializer of a cached image's columns, in two parts: rows, layers and codes, which edits of weights do not change; and
 * colors, which nearly every edit changes. For images of accuracy exact.
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
            write(cache.fineTile(i).shapes(), out);
            write(cache.fineTile(i).lights(), out);
        }
        out.writeChecksum();
    }

    private static void write(FineSamples samples, ColumnWriter out) throws IOException {
        out.writeArray(samples.pixels());
        out.writeInt(samples.blocks().length);
        for (CachedTile block : samples.blocks()) {
            write(block, out);
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
        EdgeCodes codes = tile.codes;
        out.writeInt(codes == null ? 0 : 1);
        if (codes != null) {
            out.writeArray(codes.shapes());
            out.writeArray(codes.lights());
            out.writeArray(codes.mirroredShapes());
            out.writeArray(codes.mirroredLights());
        }
    }

    public static void writeColors(PixelCache cache, ColumnWriter out) throws IOException {
        for (CachedTile tile : cache.allTiles()) {
            out.writeFloatArrays(tile.film);
            out.writeFloatArrays(tile.images == null ? null : tile.images.mirrored());
            out.writeFloatArrays(tile.images == null ? null : tile.images.refracted());
        }
        for (int i = 0; i < cache.fineCount(); i++) {
            out.writeFloatArrays(cache.fineTile(i).film());
        }
        out.writeChecksum();
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
            fine[i] = new FineTile(withColors(fine[i].shapes(), colors), withColors(fine[i].lights(), colors), null);
        }
        for (int i = 0; i < fine.length; i++) {
            fine[i] = new FineTile(fine[i].shapes(), fine[i].lights(), colors.readFloatArrays());
        }
        colors.expectEnd();
        return new PixelCache(outline.geometry(), tiles, fine, outline.scenes(), outline.lights(), outline.mirroredLights());
    }

    private static FineSamples readSamples(ColumnReader in) throws IOException {
        short[] pixels = in.readShorts();
        CachedTile[] blocks = new CachedTile[in.readCount()];
        for (int b = 0; b < blocks.length; b++) {
            blocks[b] = readTile(in);
        }
        return new FineSamples(pixels, blocks);
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
        EdgeCodes codes = in.readInt() == 0 ? null : new EdgeCodes(in.readInts(), in.readInts(), in.readInts(), in.readInts());
        return new CachedTile(levels, hitShapes, null, null, codes);
    }

    private static FineSamples withColors(FineSamples samples, ColumnReader in) throws IOException {
        CachedTile[] blocks = new CachedTile[samples.blocks().length];
        for (int b = 0; b < blocks.length; b++) {
            blocks[b] = withColors(samples.blocks()[b], in);
        }
        return new FineSamples(samples.pixels(), blocks);
    }

    private static CachedTile withColors(CachedTile tile, ColumnReader in) throws IOException {
        float[][] film = in.readFloatArrays();
        float[][] mirrored = in.readFloatArrays();
        float[][] refracted = in.readFloatArrays();
        return new CachedTile(tile.levels, tile.hitShapes, mirrored == null ? null : new BounceImages(mirrored, refracted), film,
                tile.codes);
    }

    /** Returns true if two images share the same rows, layers and codes, and differ at most in colors. */
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
            if (!hasSameRows(a.fineTile(i).shapes(), b.fineTile(i).shapes())
                    || !hasSameRows(a.fineTile(i).lights(), b.fineTile(i).lights())) {
                return false;
            }
        }
        return true;
    }

    private static boolean hasSameRows(FineSamples a, FineSamples b) {
        boolean same = a.pixels() == b.pixels() && a.blocks().length == b.blocks().length;
        for (int i = 0; same && i < a.blocks().length; i++) {
            same = hasSameRows(a.blocks()[i], b.blocks()[i]);
        }
        return same;
    }

    private static boolean hasSameRows(CachedTile a, CachedTile b) {
        boolean same = a.levels.length == b.levels.length && Arrays.deepEquals(a.hitShapes, b.hitShapes) && a.codes == b.codes;
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
