package lightning.render.cache;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.BitSet;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.gather.GatherStructure;
import lightning.render.gather.RowWeights;
import lightning.render.shading.IndirectLight;
import lightning.render.shading.StoredFilms;
import lightning.render.trace.HitRows;
import org.jspecify.annotations.Nullable;

/** Serializer of cached indirect light: its paths, the layers of its surfels, the weights of rows, and the light. */
final class IndirectSerializer {
    private static final int NO_PATHS = -1;
    private static final StoredFilms NONE = new StoredFilms(new float[0][][], new BitSet());

    /** Relation of the indirect light in mirrors to that of the scene. */
    private enum Mirrored {
        NONE, SAME, SAME_PATHS, OWN_PATHS;

        static Mirrored of(PixelCache cache) {
            IndirectCache mirrored = cache.mirrored().indirect();
            IndirectCache shown = cache.indirect();
            return mirrored == null ? NONE : mirrored == shown ? SAME
                    : shown != null && mirrored.structure() == shown.structure() ? SAME_PATHS : OWN_PATHS;
        }

        boolean isOfItsOwn() {
            return this == SAME_PATHS || this == OWN_PATHS;
        }
    }

    /**
     * Indirect light of an image.
     *
     * @param scene    that of the scene
     * @param mirrored that in mirrors
     */
    record Pair(@Nullable IndirectCache scene, @Nullable IndirectCache mirrored) {
        static Pair of(PixelCache cache) {
            return new Pair(cache.indirect(), cache.mirrored().indirect());
        }

        /** Returns the light to which weights belong; {@link #NO_PATHS} for none. */
        private int index(@Nullable RowWeights weights) {
            return weights == null ? NO_PATHS : scene != null && weights.structure() == scene.structure() ? 0
                    : mirrored != null && weights.structure() == mirrored.structure() ? 1 : NO_PATHS;
        }
    }

    private IndirectSerializer() {}

    /** Writes paths and layers of surfels. */
    static void writePaths(PixelCache cache, ColumnWriter out) throws IOException {
        Mirrored mirrored = Mirrored.of(cache);
        out.writeInt(mirrored.ordinal());
        if (cache.indirect() != null) {
            cache.indirect().structure().writeTo(out);
            writeLayers(cache.indirect(), out);
        }
        if (mirrored == Mirrored.OWN_PATHS) {
            requireNonNull(cache.mirrored().indirect()).structure().writeTo(out);
        }
        if (mirrored.isOfItsOwn()) {
            writeLayers(requireNonNull(cache.mirrored().indirect()), out);
        }
    }

    private static void writeLayers(IndirectCache indirect, ColumnWriter out) throws IOException {
        for (TileLevel block : indirect.surfels()) {
            LayerSerializer.write(block.layers(), out);
        }
    }

    /** Reads what {@link #writePaths} wrote. The light of the result is missing. */
    static Pair readPaths(CacheMetadata metadata, ColumnReader in) throws IOException {
        Mirrored mirrored = Mirrored.values()[in.readInt()];
        IndirectCache scene = metadata.indirect() == null ? null
                : readLayers(metadata.indirect(), GatherStructure.readFrom(in, metadata.indirect().metadata()), in);
        return new Pair(scene, switch (mirrored) {
            case NONE -> null;
            case SAME -> scene;
            case SAME_PATHS -> readLayers(requireNonNull(metadata.mirroredIndirect()), requireNonNull(scene).structure(), in);
            case OWN_PATHS -> {
                CacheMetadata.Paths paths = requireNonNull(metadata.mirroredIndirect());
                yield readLayers(paths, GatherStructure.readFrom(in, paths.metadata()), in);
            }
        });
    }

    private static IndirectCache readLayers(CacheMetadata.Paths metadata, GatherStructure structure, ColumnReader in) throws IOException {
        HitRows[] rows = structure.surfels();
        TileLevel[] surfels = new TileLevel[rows.length];
        for (int b = 0; b < rows.length; b++) {
            surfels[b] = new TileLevel(rows[b], LayerSerializer.read(in));
        }
        return new IndirectCache(metadata.settings(), surfels, new IndirectLight(structure, NONE, NONE.colors()));
    }

    /** Writes the weights of rows. Weights of other paths are of no use and left out. */
    static void writeWeights(@Nullable RowWeights weights, Pair indirect, ColumnWriter out) throws IOException {
        int index = indirect.index(weights);
        out.writeInt(index);
        if (weights != null && index != NO_PATHS) {
            weights.writeTo(out);
        }
    }

    /** Reads weights of rows. */
    static @Nullable RowWeights readWeights(Pair indirect, ColumnReader in) throws IOException {
        int index = in.readInt();
        return index == NO_PATHS ? null
                : RowWeights.readFrom(in, requireNonNull(index == 0 ? indirect.scene : indirect.mirrored).structure());
    }

    /** Writes the light at gather points. */
    static void writeLight(PixelCache cache, ColumnWriter out) throws IOException {
        if (cache.indirect() != null) {
            write(cache.indirect().light(), out);
        }
        if (Mirrored.of(cache).isOfItsOwn()) {
            write(requireNonNull(cache.mirrored().indirect()).light(), out);
        }
    }

    private static void write(IndirectLight light, ColumnWriter out) throws IOException {
        write(light.light(), light.films().known(), out);
        boolean hasEdges = light.edgeLight() != light.light();
        out.writeInt(hasEdges ? 1 : 0);
        if (hasEdges) {
            write(light.edgeLight(), light.films().known(), out);
        }
    }

    private static void write(float[] @Nullable [][] films, BitSet known, ColumnWriter out) throws IOException {
        out.writeInt(films.length);
        for (int film = 0; film < films.length; film++) {
            out.writeInt(known.get(film) ? 1 : 0);
            out.writeFloatArrays(films[film]);
        }
    }

    private static StoredFilms readFilms(ColumnReader in) throws IOException {
        float[] @Nullable [][] films = new float[in.readCount()][][];
        BitSet known = new BitSet();
        for (int film = 0; film < films.length; film++) {
            known.set(film, in.readInt() != 0);
            films[film] = in.readOptionalFloatArrays();
        }
        return new StoredFilms(films, known);
    }

    /** Returns indirect light with what {@link #writeLight} wrote. */
    static Pair withLight(Pair indirect, ColumnReader in) throws IOException {
        IndirectCache scene = indirect.scene == null ? null : withLight(indirect.scene, in);
        return new Pair(scene, indirect.mirrored == null ? null : indirect.mirrored == indirect.scene ? scene
                : withLight(indirect.mirrored, in));
    }

    private static IndirectCache withLight(IndirectCache dark, ColumnReader in) throws IOException {
        StoredFilms films = readFilms(in);
        return new IndirectCache(dark.settings(), dark.surfels(),
                new IndirectLight(dark.structure(), films, in.readInt() == 0 ? films.colors() : readFilms(in).colors()));
    }

    /** Returns whether two images have the same paths and layers of surfels, and differ at most in the light. */
    static boolean hasSamePaths(PixelCache a, PixelCache b) {
        return Mirrored.of(a) == Mirrored.of(b) && hasSamePaths(a.indirect(), b.indirect())
                && hasSamePaths(a.mirrored().indirect(), b.mirrored().indirect());
    }

    private static boolean hasSamePaths(@Nullable IndirectCache a, @Nullable IndirectCache b) {
        if (a == null || b == null) {
            return a == b;
        }
        boolean same = a.structure() == b.structure() && a.surfels().length == b.surfels().length;
        for (int i = 0; same && i < a.surfels().length; i++) {
            same = a.surfels()[i].sharesLayers(b.surfels()[i]);
        }
        return same;
    }
}
