package lightning.render.shading.layer;

import java.io.IOException;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import lightning.render.column.ColumnKind;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnSet;
import lightning.render.column.ColumnWriter;
import lightning.render.column.ElementType;
import lightning.render.shading.AreaSamples;
import lightning.render.shading.TermKernel;
import lightning.render.shading.Transmittance;
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;

/**
 * Term layer of one light over the hit rows of one tile and level: state, cosine, specular term and falloff. The columns share the
 * rows' index.
 *
 * <p>Rows that the light does not reach hold 0 as cosine and specular term, so that compositing can ignore the state. If no row is
 * lit, only the state column exists.
 */
public final class LightRows implements LightLayer {
    /**
     * States, tested in this order. If a cone misses the whole tile, all its rows are outside, including rows that face away. Lit
     * means potentially lit (paper §4.4), even if the falloff is 0.
     */
    public static final byte FACING_AWAY = 0;
    public static final byte OUTSIDE_CONE = 1;
    public static final byte SHADOWED = 2;
    public static final byte LIT = 3;
    public static final int STATE_MASK = 3;
    /** Flags of a known shadow ray result; independent of the state. */
    public static final int UNBLOCKED = 4;
    public static final int BLOCKED = 8;
    /** Flag of a row in the penumbra of an area light, which uses all samples; only with {@link #UNBLOCKED}. */
    public static final int REFINED = 16;
    /** Mask of the shadow ray flags; all are 0 if no shadow ray was cast. */
    static final int SHADOW_RAY_MASK = UNBLOCKED | BLOCKED | REFINED;
    /** Number of samples per column of visible samples. */
    static final int SAMPLES_PER_COLUMN = 16;

    /**
     * What a layer holds. A value rather than a type of its own for each: hot loops read the columns of all kinds in the same way.
     */
    public enum Kind {
        /** The light's cone misses the tile: no row was tested. Shared by all such tiles: {@link LightRows#UNREACHED}. */
        UNREACHED,
        /** Rows were tested, and none is lit: states and shadow rays only. */
        UNLIT,
        /** Terms of lit rows, with the falloff apart from the cosine. Without a falloff column the light has no falloff: it is 1. */
        SEPARATE,
        /** Terms of lit rows without highlights; the cosines include the falloff. */
        PREMULTIPLIED
    }

    /** Columns of a layer. All code that creates, counts and splices layers uses this list. */
    public enum Column implements ColumnKind {
        STATE(ElementType.BYTE, "light states"),
        COSINE(ElementType.FLOAT, "cosines"),
        SPECULAR(ElementType.FLOAT, "specular terms"),
        /** Only for a light over metallic materials. */
        GRAZING(ElementType.FLOAT, "grazing terms"),
        FALLOFF(ElementType.FLOAT, "falloffs"),
        /** Only for an area light: set of visible samples 0…15, 16…31 and so on. */
        SEEN_0(ElementType.SHORT, "visible samples of area lights"),
        SEEN_1(ElementType.SHORT, "visible samples of area lights"),
        SEEN_2(ElementType.SHORT, "visible samples of area lights"),
        SEEN_3(ElementType.SHORT, "visible samples of area lights"),
        /** Transmittance of clear shapes on an unblocked shadow ray; 1 if there are none. */
        TINT_RED(ElementType.FLOAT, "tinted shadow colors"),
        TINT_GREEN(ElementType.FLOAT, "tinted shadow colors"),
        TINT_BLUE(ElementType.FLOAT, "tinted shadow colors"),
        /** Only for a light with an image: mean color of its samples, weighted by their diffuse terms. */
        FACE_RED(ElementType.FLOAT, "colors of images on lights"),
        FACE_GREEN(ElementType.FLOAT, "colors of images on lights"),
        FACE_BLUE(ElementType.FLOAT, "colors of images on lights"),
        /** Mean color of the samples, weighted by their specular terms; only with a specular column. */
        HIGHLIGHT_RED(ElementType.FLOAT, "colors of images on lights"),
        HIGHLIGHT_GREEN(ElementType.FLOAT, "colors of images on lights"),
        HIGHLIGHT_BLUE(ElementType.FLOAT, "colors of images on lights");

        static final List<Column> SAMPLE_COLUMNS = List.of(SEEN_0, SEEN_1, SEEN_2, SEEN_3);
        static final List<Column> TINT_COLUMNS = List.of(TINT_RED, TINT_GREEN, TINT_BLUE);
        static final List<Column> FACE_COLUMNS = List.of(FACE_RED, FACE_GREEN, FACE_BLUE);
        static final List<Column> HIGHLIGHT_COLUMNS = List.of(HIGHLIGHT_RED, HIGHLIGHT_GREEN, HIGHLIGHT_BLUE);
        /** Three columns of factors each, which are 1 where they are missing. */
        static final List<List<Column>> COLOR_COLUMNS = List.of(TINT_COLUMNS, FACE_COLUMNS, HIGHLIGHT_COLUMNS);

        private final ElementType element;
        private final String title;

        Column(ElementType element, String title) {
            this.element = element;
            this.title = title;
        }

        /** Returns the title for reports. */
        public String title() {
            return title;
        }

        @Override
        public ElementType element() {
            return element;
        }
    }

    /** Columns that are uniform for a distant light on a plane. */
    private static final Set<Column> UNIFORM_COLUMNS = EnumSet.of(Column.COSINE);
    private static final float[] ONES = ones();
    private static final float[] ZEROS = new float[TermKernel.MAX_ROWS];
    /** Kinds in a file that its columns do not tell. */
    private static final int UNREACHED_FLAG = 1;
    private static final int PREMULTIPLIED_FLAG = 2;
    /** For each state and flag, a uniform state column that layers share. Not counted as memory. */
    private static final byte[][] UNIFORM_STATES = uniformStates();
    private static final float[][] WHITE_TINT = {ONES, ONES, ONES};

    /** Layer whose rows are all outside: shared by all tiles that a light does not reach, and not counted as memory. */
    public static final LightRows UNREACHED = new LightRows(
            ColumnSet.of(Column.class, uniformStates(OUTSIDE_CONE)), 0, Kind.UNREACHED);

    /** Columns that a premultiplied layer does not have. */
    private static final Set<Column> SEPARATE_COLUMNS = EnumSet.of(Column.SPECULAR, Column.FALLOFF);

    /** State and shadow ray flags of each row. */
    public final byte[] state;
    /** N·L, or the diffuse term of a metallic material; null if no row is lit. */
    public final float @Nullable [] cosine;
    /** max(V·R, 0)<sup>shininess</sup>, or the factor of F0 for a metallic material; null if no row is lit or none is specular. */
    public final float @Nullable [] specular;
    /** Grazing terms of metallic materials; null if no row is lit or none is metallic. */
    public final float @Nullable [] grazing;
    /** atten·spot; only for kind {@link Kind#SEPARATE}, and null there if it is 1. */
    public final float @Nullable [] falloff;
    /** Columns of visible samples, more than the light's own only if a row is refined; null if it has one sample or no row sees any. */
    final short @Nullable [][] visibleSamples;
    /** Red, green and blue tints of unblocked shadow rays; null if all are 1. */
    public final float @Nullable [][] tint;
    /** Mean colors of the light's image for the diffuse terms: red, green and blue; null if all are 1. */
    public final float @Nullable [][] face;
    /** Mean colors of the light's image for the specular and grazing terms; null if all are 1. */
    public final float @Nullable [][] highlight;
    /** Number of lit rows. */
    public final int litCount;
    private final Kind kind;

    private final ColumnSet<Column> columns;
    /** Bytes that compositing reads, computed on first use; 0 before. Columns are not touched again for it. */
    private int compositingBytes;

    private LightRows(ColumnSet<Column> columns, int lit, Kind kind) {
        this.columns = columns;
        this.litCount = lit;
        this.kind = kind;
        state = (byte[]) columns.get(Column.STATE);
        cosine = (float[]) columns.find(Column.COSINE);
        specular = (float[]) columns.find(Column.SPECULAR);
        grazing = (float[]) columns.find(Column.GRAZING);
        falloff = (float[]) columns.find(Column.FALLOFF);
        visibleSamples = readVisibleSamples(columns, Column.SAMPLE_COLUMNS);
        tint = readChannels(columns, Column.TINT_COLUMNS);
        face = readChannels(columns, Column.FACE_COLUMNS);
        highlight = readChannels(columns, Column.HIGHLIGHT_COLUMNS);
    }

    /** Returns the column of samples 16·{@code group} and up. */
    public static short @Nullable [] sampleColumn(short @Nullable [][] visibleSamples, int group) {
        return visibleSamples == null || visibleSamples.length <= group ? null : visibleSamples[group];
    }

    /** Returns the existing sample columns, a prefix of the kinds; null if there are none. */
    public static <C extends Enum<C> & ColumnKind> short @Nullable [][] readVisibleSamples(ColumnSet<C> columns, List<C> kinds) {
        return !columns.has(kinds.getFirst()) ? null
                : kinds.stream().filter(columns::has).map(kind -> (short[]) columns.get(kind)).toArray(short[][]::new);
    }

    /** Returns three columns; null if the first does not exist. */
    public static <C extends Enum<C> & ColumnKind> float @Nullable [][] readChannels(ColumnSet<C> columns, List<C> channels) {
        return !columns.has(channels.getFirst()) ? null
                : channels.stream().map(channel -> (float[]) columns.get(channel)).toArray(float[][]::new);
    }

    /** Returns the columns with three of them replaced, or removed if {@code colors} is null. */
    public static <C extends Enum<C> & ColumnKind> ColumnSet<C> withChannels(ColumnSet<C> columns, List<C> channels,
            float @Nullable [][] colors) {
        ColumnSet<C> result = columns;
        for (int c = 0; c < channels.size(); c++) {
            result = result.with(channels.get(c), colors == null ? null : colors[c]);
        }
        return result;
    }

    /** Returns the columns with missing factors filled with 1. */
    static ColumnSet<Column> withDefaultColors(ColumnSet<Column> columns) {
        ColumnSet<Column> result = columns;
        for (List<Column> channels : Column.COLOR_COLUMNS) {
            result = withDefaultTint(result, channels);
        }
        return result;
    }

    /** Returns the columns with missing tints filled with 1. */
    public static <C extends Enum<C> & ColumnKind> ColumnSet<C> withDefaultTint(ColumnSet<C> columns, List<C> channels) {
        return columns.has(channels.getFirst()) ? columns : withChannels(columns, channels, WHITE_TINT);
    }

    /**
     * Returns the columns that layers of a light may have.
     *
     * @param metallic true if any material is metallic
     * @param tinted   true if light passes through any material
     */
    public static Set<Column> columns(Light light, boolean metallic, boolean tinted) {
        Set<Column> columns = EnumSet.allOf(Column.class);
        if (!tinted) {
            columns.removeAll(Column.TINT_COLUMNS);
        }
        if (!metallic) {
            columns.remove(Column.GRAZING);
        }
        if (light.sampleImage().isEmpty()) {
            columns.removeAll(Column.FACE_COLUMNS);
            columns.removeAll(Column.HIGHLIGHT_COLUMNS);
        }
        columns.removeAll(Column.SAMPLE_COLUMNS.subList(sampleColumnCount(light), Column.SAMPLE_COLUMNS.size()));
        if (light.isArea()) {
            columns.remove(Column.FALLOFF);
        }
        return columns;
    }

    /** Returns the largest number of sample columns of a light; 0 for a point light. */
    public static int sampleColumnCount(Light light) {
        return light.isArea() ? (AreaSamples.refined(light.area().samples()) - 1) / SAMPLES_PER_COLUMN + 1 : 0;
    }

    /** Creates a layer without lit rows. */
    public static LightRows unlit(byte[] state) {
        return new LightRows(ColumnSet.of(Column.class, state), 0, Kind.UNLIT);
    }

    /** Creates a layer without lit rows, in which samples may be visible. */
    static LightRows unlit(byte[] state, short @Nullable [][] visibleSamples) {
        return unlit(state).withVisibleSamples(visibleSamples);
    }

    /**
     * Terms of all rows, 0 for rows that are not lit.
     *
     * @param cosine   as {@link LightRows#cosine}
     * @param specular as {@link LightRows#specular}; null if no row has a highlight
     * @param grazing  as {@link LightRows#grazing}; null if no row is metallic
     * @param falloff  as {@link LightRows#falloff}; null if all are 1
     */
    public record Terms(float @Nullable [] cosine, float @Nullable [] specular, float @Nullable [] grazing, float @Nullable [] falloff) {}

    /**
     * Creates a layer of one sample with the falloff apart.
     *
     * @param lit number of lit rows, at least 1
     */
    public static LightRows lit(byte[] state, Terms terms, int lit) {
        return lit(ColumnSet.of(Column.class, state, terms.cosine, terms.specular, terms.grazing, terms.falloff), lit);
    }

    /** Creates a layer with terms of {@code lit} rows, at least 1, and the falloff apart. */
    static LightRows lit(ColumnSet<Column> columns, int lit) {
        return new LightRows(columns, lit, Kind.SEPARATE);
    }

    /** Creates a layer with terms of {@code lit} rows, at least 1, whose cosines include the falloff. */
    static LightRows premultiplied(ColumnSet<Column> columns, int lit) {
        return new LightRows(columns, lit, Kind.PREMULTIPLIED);
    }

    private LightRows withColumns(ColumnSet<Column> changed) {
        return new LightRows(changed, litCount, kind);
    }

    /** Returns this layer with other visible samples, or without them if null. */
    public LightRows withVisibleSamples(short @Nullable [][] samples) {
        if (samples == visibleSamples) {
            return this;
        }
        ColumnSet<Column> changed = columns;
        for (int group = 0; group < Column.SAMPLE_COLUMNS.size(); group++) {
            Column kind = Column.SAMPLE_COLUMNS.get(group);
            short[] column = sampleColumn(samples, group);
            changed = column == changed.find(kind) ? changed : changed.with(kind, column);
        }
        return withColumns(changed);
    }

    /** Returns this layer with falloffs apart from the cosines; null if all are 1. */
    public LightRows withFalloff(float @Nullable [] falloffs) {
        return new LightRows(columns.with(Column.FALLOFF, falloffs), litCount, Kind.SEPARATE);
    }

    /** Returns this layer with other tints, or without tints if null. */
    public LightRows withTint(float @Nullable [][] tints) {
        return tints == tint ? this : withColumns(withChannels(columns, Column.TINT_COLUMNS, tints));
    }

    /** Returns this layer with other colors of the light's image for its diffuse and specular terms, or without them if null. */
    LightRows withFaceColors(float @Nullable [][] diffuse, float @Nullable [][] specular) {
        return diffuse == face && specular == highlight ? this
                : withColumns(withChannels(withChannels(columns, Column.FACE_COLUMNS, diffuse), Column.HIGHLIGHT_COLUMNS, specular));
    }

    /** Returns this layer without specular terms. */
    LightRows withoutSpecular() {
        return with(Column.SPECULAR, null).withFaceColors(face, null);
    }

    /**
     * Returns the factor of one channel of a row's terms without the gain: tint times the mean color of the light's image.
     *
     * @param colors {@link #face} or {@link #highlight}
     */
    public float factor(float @Nullable [][] colors, int channel, int row) {
        float tinted = tint == null ? 1 : tint[channel][row];
        return colors == null ? tinted : tinted * colors[channel][row];
    }

    /** Returns this layer with another column, or without it if null; the same rows are lit. */
    LightRows with(Column column, float @Nullable [] values) {
        return withColumns(columns.with(column, values));
    }

    private static float[] ones() {
        float[] ones = new float[TermKernel.MAX_ROWS];
        Arrays.fill(ones, 1);
        return ones;
    }

    private static byte[] uniformStates(int state) {
        byte[] states = new byte[TermKernel.MAX_ROWS];
        Arrays.fill(states, (byte) state);
        return states;
    }

    private static byte[][] uniformStates() {
        byte[][] all = new byte[STATE_MASK + SHADOW_RAY_MASK + 1][];
        Arrays.setAll(all, LightRows::uniformStates);
        return all;
    }

    /** Returns the bytes of a layer's columns that all layers share and that are not counted. */
    public static long sharedBytes(byte[] states) {
        return states == UNREACHED.state || states.length > 0 && states == UNIFORM_STATES[states[0]] ? states.length : 0;
    }

    /**
     * Returns this layer over {@code rows} rows without redundant columns: shares uniform states and cosines, and drops highlights
     * that are all 0. Adding nothing instead of +0 to sums that are never negative changes no bit. Grazing terms are composed
     * together with specular ones, so both stay if there are any.
     */
    public LightRows compact(int rows) {
        ColumnSet<Column> compacted = columns.withUniform(UNIFORM_COLUMNS, rows);
        if (rows > 0 && sharedBytes(state) == 0 && Arrays.equals(state, 0, rows, UNIFORM_STATES[state[0]], 0, rows)) {
            compacted = compacted.with(Column.STATE, UNIFORM_STATES[state[0]]);
        }
        if (specular != null && grazing == null && !hasHighlight(rows)) {
            compacted = compacted.with(Column.SPECULAR, null);
            compacted = highlight == null ? compacted : withChannels(compacted, Column.HIGHLIGHT_COLUMNS, null);
        }
        return compacted == columns ? this : withColumns(compacted);
    }

    /** Returns what the layer holds. */
    public Kind kind() {
        return kind;
    }

    @Override
    public boolean isUnreached() {
        return kind == Kind.UNREACHED;
    }

    /** Returns whether the cosines include the falloff. */
    boolean isPremultiplied() {
        return kind == Kind.PREMULTIPLIED;
    }

    /**
     * Returns a compact copy over {@code rows} rows with one column, cosine times falloff, instead of two, if no row has a highlight.
     * Compositing uses only this product, so the bits are the same. A later falloff edit must recompute the cosines.
     */
    public LightRows copyPremultiplied(int rows) {
        if (falloff == null || grazing != null || specular != null && hasHighlight(rows)) {
            return copyCompact(rows);
        }
        assert cosine != null;
        ColumnSet<Column> own = columns.without(SEPARATE_COLUMNS).deepCopy(rows);
        float[] product = own.get(Column.COSINE) == cosine ? cosine.clone() : (float[]) own.get(Column.COSINE);
        for (int i = 0; i < rows; i++) {
            product[i] = cosine[i] * falloff[i];
        }
        return premultiplied(own.with(Column.COSINE, product), litCount).compact(rows);
    }

    private boolean hasHighlight(int rows) {
        return !Arrays.equals(specular, 0, rows, ZEROS, 0, rows);
    }

    /** Returns a {@linkplain #compact compact} copy of this layer over {@code rows} rows. */
    public LightRows copyCompact(int rows) {
        if (isUnreached()) {
            return this;
        }
        LightRows compact = compact(rows);
        ColumnSet<Column> own = compact.columns.deepCopy(rows);
        return withColumns(sharedBytes(compact.state) > 0 ? own.with(Column.STATE, compact.state) : own);
    }

    /** Returns the state of a row without the flags. */
    public int state(int row) {
        return state[row] & STATE_MASK;
    }

    @Override
    public byte[] states() {
        return state;
    }

    @Override
    public short @Nullable [][] visibleSamples() {
        return visibleSamples;
    }

    @Override
    public float @Nullable [][] tint() {
        return tint;
    }

    @Override
    public int litCount() {
        return litCount;
    }

    /** Writes the layer. */
    public void writeTo(ColumnWriter out) throws IOException {
        out.writeInt(litCount);
        out.writeInt(switch (kind) {
            case UNREACHED -> UNREACHED_FLAG;
            case UNLIT, SEPARATE -> 0;
            case PREMULTIPLIED -> PREMULTIPLIED_FLAG;
        });
        out.writeColumns(isUnreached() ? columns.with(Column.STATE, null) : columns);
    }

    /**
     * Reads a layer.
     *
     * @throws IOException if the data is truncated
     */
    public static LightRows readFrom(ColumnReader in) throws IOException {
        int lit = in.readInt();
        int flag = in.readInt();
        ColumnSet<Column> read = in.readColumns(Column.class);
        if (flag == UNREACHED_FLAG) {
            return UNREACHED;
        }
        LightRows layer = new LightRows(read, lit, flag == PREMULTIPLIED_FLAG ? Kind.PREMULTIPLIED : lit == 0 ? Kind.UNLIT : Kind.SEPARATE);
        // Shared columns were written at the length of a full tile.
        return layer.compact(Math.min(layer.state.length, Math.min(length(layer.cosine), length(layer.specular))));
    }

    private static int length(float @Nullable [] column) {
        return column == null ? Integer.MAX_VALUE : column.length;
    }

    /** Returns the columns of this layer. */
    ColumnSet<Column> columns() {
        return columns;
    }

    @Override
    public long bytes() {
        return columns.bytes() - sharedBytes(state);
    }

    /** Returns the bytes of one kind of column. */
    public long bytes(Column kind) {
        return columns.bytes(kind) - (kind == Column.STATE ? sharedBytes(state) : 0);
    }

    @Override
    public long bytesReadByCompositing() {
        if (compositingBytes == 0) {
            compositingBytes = (int) (columns.bytes() - columns.bytes(Column.STATE));
        }
        return compositingBytes;
    }

    /** A new falloff needs only the point; new terms need point, normal and direction. */
    @Override
    public long rowBytesRead(@Nullable LightLayer before) {
        return before instanceof LightRows b && cosine != null && b.cosine == cosine && b.state == state ? 12 : 36;
    }

    @Override
    public long newBytes(@Nullable LightLayer before) {
        if (!(before instanceof LightRows b)) {
            return bytes();
        }
        return columns.newBytes(b.columns) - (state == b.state ? 0 : sharedBytes(state));
    }
}
