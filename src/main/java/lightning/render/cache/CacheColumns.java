package lightning.render.cache;

import java.io.IOException;
import java.util.Arrays;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.shading.EdgeCodes;
import lightning.render.shading.Images;
import lightning.render.shading.LightLayer;
import lightning.render.shading.LightRows;
import lightning.render.trace.HitRows;

/**
 * All columns of a picture, one behind the other, in two parts: rows, layers and codes, which edits of weights leave alone; and colours,
 * which nearly every edit changes. For pictures of accuracy exact.
 */
public final class CacheColumns {
    private CacheColumns() {}

    public static void writeRows(PixelCache cache, ColumnWriter out) throws IOException {
        out.number(cache.tileCount());
        for (CachedTile tile : cache.tiles()) {
            write(tile, out);
        }
        out.number(cache.fineCount());
        for (int i = 0; i < cache.fineCount(); i++) {
            write(cache.fine(i).shapes(), out);
            write(cache.fine(i).lights(), out);
        }
        out.end();
    }

    private static void write(FineSamples samples, ColumnWriter out) throws IOException {
        out.array(samples.pixels());
        out.number(samples.blocks().length);
        for (CachedTile block : samples.blocks()) {
            write(block, out);
        }
    }

    private static void write(CachedTile tile, ColumnWriter out) throws IOException {
        out.number(tile.levels.length);
        for (TileLevel level : tile.levels) {
            level.rows().writeTo(out);
            out.number(level.layers().length);
            for (LightLayer layer : level.layers()) {
                out.number(layer == null ? 0 : 1);
                if (layer != null) {
                    ((LightRows) layer).writeTo(out);
                }
            }
        }
        out.number(tile.hitShapes.length);
        for (int[] shapes : tile.hitShapes) {
            out.array(shapes);
        }
        EdgeCodes codes = tile.codes;
        out.number(codes == null ? 0 : 1);
        if (codes != null) {
            out.array(codes.shapes());
            out.array(codes.lights());
            out.array(codes.mirroredShapes());
            out.array(codes.mirroredLights());
        }
    }

    public static void writeColors(PixelCache cache, ColumnWriter out) throws IOException {
        for (CachedTile tile : cache.all()) {
            out.arrays(tile.film);
            out.arrays(tile.images == null ? null : tile.images.mirrored());
            out.arrays(tile.images == null ? null : tile.images.refracted());
        }
        for (int i = 0; i < cache.fineCount(); i++) {
            out.arrays(cache.fine(i).film());
        }
        out.end();
    }

    /** The picture of these columns. */
    public static PixelCache read(CacheOutline outline, ColumnReader rows, ColumnReader colors) throws IOException {
        CachedTile[] tiles = new CachedTile[rows.count()];
        for (int i = 0; i < tiles.length; i++) {
            tiles[i] = tile(rows);
        }
        FineTile[] fine = new FineTile[rows.count()];
        for (int i = 0; i < fine.length; i++) {
            fine[i] = new FineTile(samples(rows), samples(rows), null);
        }
        rows.end();
        for (int i = 0; i < tiles.length; i++) {
            tiles[i] = colored(tiles[i], colors);
        }
        for (int i = 0; i < fine.length; i++) {
            fine[i] = new FineTile(colored(fine[i].shapes(), colors), colored(fine[i].lights(), colors), null);
        }
        for (int i = 0; i < fine.length; i++) {
            fine[i] = new FineTile(fine[i].shapes(), fine[i].lights(), colors.arrays());
        }
        colors.end();
        return new PixelCache(outline.geometry(), tiles, fine, outline.scenes(), outline.lights(), outline.mirroredLights());
    }

    private static FineSamples samples(ColumnReader in) throws IOException {
        short[] pixels = in.shorts();
        CachedTile[] blocks = new CachedTile[in.count()];
        for (int b = 0; b < blocks.length; b++) {
            blocks[b] = tile(in);
        }
        return new FineSamples(pixels, blocks);
    }

    private static CachedTile tile(ColumnReader in) throws IOException {
        TileLevel[] levels = new TileLevel[in.count()];
        for (int l = 0; l < levels.length; l++) {
            HitRows rows = HitRows.readFrom(in);
            LightLayer[] layers = new LightLayer[in.count()];
            for (int i = 0; i < layers.length; i++) {
                layers[i] = in.number() == 0 ? null : LightRows.readFrom(in);
            }
            levels[l] = new TileLevel(rows, layers);
        }
        int[][] hitShapes = new int[in.count()][];
        for (int i = 0; i < hitShapes.length; i++) {
            hitShapes[i] = in.ints();
        }
        EdgeCodes codes = in.number() == 0 ? null : new EdgeCodes(in.ints(), in.ints(), in.ints(), in.ints());
        return new CachedTile(levels, hitShapes, null, null, codes);
    }

    private static FineSamples colored(FineSamples samples, ColumnReader in) throws IOException {
        CachedTile[] blocks = new CachedTile[samples.blocks().length];
        for (int b = 0; b < blocks.length; b++) {
            blocks[b] = colored(samples.blocks()[b], in);
        }
        return new FineSamples(samples.pixels(), blocks);
    }

    private static CachedTile colored(CachedTile tile, ColumnReader in) throws IOException {
        float[][] film = in.arrays();
        float[][] mirrored = in.arrays();
        float[][] refracted = in.arrays();
        return new CachedTile(tile.levels, tile.hitShapes, mirrored == null ? null : new Images(mirrored, refracted), film, tile.codes);
    }

    /** Whether two pictures have the very same rows, layers and codes, and differ in colours at most. */
    public static boolean shareRows(PixelCache a, PixelCache b) {
        if (a.tileCount() != b.tileCount() || a.fineCount() != b.fineCount()) {
            return false;
        }
        for (int i = 0; i < a.tileCount(); i++) {
            if (!shareRows(a.tile(i), b.tile(i))) {
                return false;
            }
        }
        for (int i = 0; i < a.fineCount(); i++) {
            if (!shareRows(a.fine(i).shapes(), b.fine(i).shapes()) || !shareRows(a.fine(i).lights(), b.fine(i).lights())) {
                return false;
            }
        }
        return true;
    }

    private static boolean shareRows(FineSamples a, FineSamples b) {
        boolean shared = a.pixels() == b.pixels() && a.blocks().length == b.blocks().length;
        for (int i = 0; shared && i < a.blocks().length; i++) {
            shared = shareRows(a.blocks()[i], b.blocks()[i]);
        }
        return shared;
    }

    private static boolean shareRows(CachedTile a, CachedTile b) {
        boolean shared = a.levels.length == b.levels.length && Arrays.deepEquals(a.hitShapes, b.hitShapes) && a.codes == b.codes;
        for (int l = 0; shared && l < a.levels.length; l++) {
            LightLayer[] before = a.levels[l].layers();
            LightLayer[] after = b.levels[l].layers();
            shared = a.levels[l].rows() == b.levels[l].rows() && before.length == after.length;
            for (int i = 0; shared && i < before.length; i++) {
                shared = before[i] == after[i];
            }
        }
        return shared;
    }
}
