package lightning.render.cache;

import java.io.IOException;
import java.util.Arrays;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.shading.BounceImages;
import lightning.render.shading.EdgeColors;
import lightning.render.shading.fog.PictureFog;
import lightning.render.trace.HitRows;
import lightning.render.trace.SampleCells;
import org.jspecify.annotations.Nullable;

/**
 * Serializer of a cached image's columns, in two parts: rows, layers, edge colors and paths of indirect light, which edits of weights do
 * not change; and colors and indirect light, which nearly every edit changes. For images of accuracy exact.
 */
public final class CacheSerializer {
    private CacheSerializer() {}

    public static void writeRows(PixelCache cache, ColumnWriter out) throws IOException {
        IndirectSerializer.writePaths(cache, out);
        var indirect = IndirectSerializer.Pair.of(cache);
        out.writeInt(cache.tileCount());
        for (CachedTile tile : cache.tiles()) {
            write(tile, indirect, out);
        }
        out.writeInt(cache.fineCount());
        for (int i = 0; i < cache.fineCount(); i++) {
            for (FineSamples samples : cache.fineTile(i).stages()) {
                write(samples, indirect, out);
            }
        }
        out.writeChecksum();
    }

    private static void write(FineSamples samples, IndirectSerializer.Pair indirect, ColumnWriter out) throws IOException {
        out.writeInt(samples.cells().grid());
        out.writeArray(samples.cells().cells());
        out.writeArray(samples.pixels());
        out.writeInt(samples.blocks().length);
        for (SampleBlock block : samples.blocks()) {
            out.writeArray(block.pixels());
            write(block.rows(), indirect, out);
        }
    }

    private static void write(CachedTile tile, IndirectSerializer.Pair indirect, ColumnWriter out) throws IOException {
        out.writeInt(tile.levels().length);
        for (TileLevel level : tile.levels()) {
            level.rows().writeTo(out);
            LayerSerializer.write(level.layers(), out);
            IndirectSerializer.writeWeights(level.weights(), indirect, out);
        }
        out.writeInt(tile.hitShapes().length);
        for (int[] shapes : tile.hitShapes()) {
            out.writeArray(shapes);
        }
        out.writeInt(tile.edges() == null ? 0 : 1);
        if (tile.edges() != null) {
            out.writeArray(tile.edges().colors());
            write(tile.edges().images(), out);
        }
    }

    public static void writeColors(PixelCache cache, ColumnWriter out) throws IOException {
        IndirectSerializer.writeLight(cache, out);
        FogSerializer.write(cache.shown(), out);
        FogSerializer.write(cache.mirrored(), out);
        for (CachedTile tile : cache.tiles()) {
            writeColors(tile, out);
        }
        for (int i = 0; i < cache.fineCount(); i++) {
            for (SampleBlock block : cache.fineTile(i).blocks().toList()) {
                writeColors(block.rows(), out);
            }
            out.writeFloatArrays(cache.fineTile(i).film());
        }
        out.writeChecksum();
    }

    private static void writeColors(CachedTile tile, ColumnWriter out) throws IOException {
        out.writeFloatArrays(tile.film());
        write(tile.images(), out);
        FogSerializer.write(tile.fog(), out);
    }

    private static void write(@Nullable BounceImages images, ColumnWriter out) throws IOException {
        out.writeFloatArrays(images == null ? null : images.mirrored());
        out.writeFloatArrays(images == null ? null : images.refracted());
    }

    /** Reads the image of these columns. */
    public static PixelCache read(CacheMetadata outline, ColumnReader rows, ColumnReader colors) throws IOException {
        IndirectSerializer.Pair paths = IndirectSerializer.readPaths(outline, rows);
        CachedTile[] tiles = new CachedTile[rows.readCount()];
        for (int i = 0; i < tiles.length; i++) {
            tiles[i] = readTile(paths, rows);
        }
        FineTile[] fine = new FineTile[rows.readCount()];
        for (int i = 0; i < fine.length; i++) {
            fine[i] = new FineTile(readSamples(paths, rows), readSamples(paths, rows), null, null);
        }
        rows.expectEnd();
        IndirectSerializer.Pair indirect = IndirectSerializer.withLight(paths, colors);
        PictureFog fog = FogSerializer.read(outline.scenes().scene(), colors);
        PictureFog bounceFog = FogSerializer.read(outline.scenes().mirrored(), colors);
        for (int i = 0; i < tiles.length; i++) {
            tiles[i] = withColors(tiles[i], fog, colors);
        }
        for (int i = 0; i < fine.length; i++) {
            fine[i] =
                    new FineTile(withColors(fine[i].first(), fog, colors), withColors(fine[i].rest(), fog, colors), null,
                            colors.readOptionalFloatArrays());
        }
        colors.expectEnd();
        return new PixelCache(outline.geometry(), tiles, fine,
                new CachedScene(outline.scenes().scene(), outline.lights(), indirect.scene(), fog),
                new CachedScene(outline.scenes().mirrored(), outline.mirroredLights(), indirect.mirrored(), bounceFog), false);
    }

    private static FineSamples readSamples(IndirectSerializer.Pair indirect, ColumnReader in) throws IOException {
        SampleCells cells = new SampleCells(in.readInt(), in.readInts());
        short[] pixels = in.readShorts();
        SampleBlock[] blocks = new SampleBlock[in.readCount()];
        for (int b = 0; b < blocks.length; b++) {
            blocks[b] = new SampleBlock(in.readShorts(), readTile(indirect, in), null);
        }
        return new FineSamples(cells, pixels, blocks);
    }

    private static CachedTile readTile(IndirectSerializer.Pair indirect, ColumnReader in) throws IOException {
        TileLevel[] levels = new TileLevel[in.readCount()];
        for (int l = 0; l < levels.length; l++) {
            HitRows rows = HitRows.readFrom(in);
            levels[l] = new TileLevel(rows, LayerSerializer.read(in)).withWeights(IndirectSerializer.readWeights(indirect, in));
        }
        int[][] hitShapes = new int[in.readCount()][];
        for (int i = 0; i < hitShapes.length; i++) {
            hitShapes[i] = in.readInts();
        }
        EdgeColors edges = in.readInt() == 0 ? null : new EdgeColors(in.readInts(), readImages(in));
        return new CachedTile(levels, hitShapes, null, null, null, edges, null);
    }

    private static FineSamples withColors(FineSamples samples, @Nullable PictureFog fog, ColumnReader in) throws IOException {
        SampleBlock[] blocks = new SampleBlock[samples.blocks().length];
        for (int b = 0; b < blocks.length; b++) {
            SampleBlock block = samples.blocks()[b];
            blocks[b] = new SampleBlock(block.pixels(), withColors(block.rows(), fog, in), null);
        }
        return new FineSamples(samples.cells(), samples.pixels(), blocks);
    }

    private static CachedTile withColors(CachedTile tile, @Nullable PictureFog fog, ColumnReader in) throws IOException {
        float[][] film = in.readOptionalFloatArrays();
        return new CachedTile(tile.levels(), tile.hitShapes(), readImages(in), film, null, tile.edges(), FogSerializer.read(fog, in));
    }

    private static @Nullable BounceImages readImages(ColumnReader in) throws IOException {
        float[][] mirrored = in.readOptionalFloatArrays();
        float[][] refracted = in.readOptionalFloatArrays();
        return mirrored == null ? null : new BounceImages(mirrored, refracted);
    }

    /** Returns whether two images share the same rows, layers, edge colors and paths, and differ at most in colors and indirect light. */
    public static boolean hasSameRows(PixelCache a, PixelCache b) {
        if (!IndirectSerializer.hasSamePaths(a, b) || a.tileCount() != b.tileCount() || a.fineCount() != b.fineCount()) {
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
        boolean same = a.levels().length == b.levels().length && Arrays.deepEquals(a.hitShapes(), b.hitShapes()) && a.edges() == b.edges();
        for (int l = 0; same && l < a.levels().length; l++) {
            same = a.levels()[l].rows() == b.levels()[l].rows() && a.levels()[l].weights() == b.levels()[l].weights()
                    && a.levels()[l].sharesLayers(b.levels()[l]);
        }
        return same;
    }
}
