package lightning.render.shading;

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
import lightning.render.column.UniformColumns;
import lightning.scene.Light;

/**
 * One light's layer over the hit rows of one tile and level: state, cosine, specular term and
 * falloff, in columns that share the rows' index.
 *
 * <p>Rows that the light does not reach hold 0 in cosine and specular term, so that composing need not
 * ask for the state. Where no row is lit there are no columns but the state.
 */
public final class LightRows implements LightLayer {
    /**
     * States, decided in this order, but that all rows of a tile that a cone cannot reach are outside, whether or not they
     * face away; lit means potentially lit (paper §4.4), even with a falloff of 0. */
    public static final byte FACING_AWAY = 0;
    public static final byte OUTSIDE_CONE = 1;
    public static final byte SHADOWED = 2;
    public static final byte LIT = 3;
    public static final int STATE_MASK = 3;
    /** Whether the way to the light is free, as far as known; kept apart from the state. */
    public static final int UNBLOCKED = 4;
    public static final int BLOCKED = 8;
    /** What is known of the way: neither, where nobody asked. */
    static final int SHADOW_RAY_MASK = UNBLOCKED | BLOCKED;
    /** Samples in a column of those that a row sees. */
    static final int SAMPLES_PER_COLUMN = 16;

    /** All columns that there are: what makes, counts and splices layers knows no others. */
    public enum Column implements ColumnKind {
        STATE(ElementType.BYTE, "light states"),
        COSINE(ElementType.FLOAT, "cosines"),
        SPECULAR(ElementType.FLOAT, "specular terms"),
        /** Of a light over metallic materials. */
        GRAZING(ElementType.FLOAT, "grazing terms"),
        FALLOFF(ElementType.FLOAT, "falloffs"),
        /** Of a light that is larger than a point: to which of its samples 0…15, 16…31 and so on a row's ways are free. */
        SEEN_0(ElementType.SHORT, "visible samples of area lights"),
        SEEN_1(ElementType.SHORT, "visible samples of area lights"),
        SEEN_2(ElementType.SHORT, "visible samples of area lights"),
        SEEN_3(ElementType.SHORT, "visible samples of area lights"),
        /** What passes of the light on a free way through clear shapes; 1 where none is in between. */
        TINT_RED(ElementType.FLOAT, "tinted shadow colors"),
        TINT_GREEN(ElementType.FLOAT, "tinted shadow colors"),
        TINT_BLUE(ElementType.FLOAT, "tinted shadow colors");

        static final List<Column> SAMPLE_COLUMNS = List.of(SEEN_0, SEEN_1, SEEN_2, SEEN_3);
        static final List<Column> TINT_COLUMNS = List.of(TINT_RED, TINT_GREEN, TINT_BLUE);

        private final ElementType element;
        private final String title;

        Column(ElementType element, String title) {
            this.element = element;
            this.title = title;
        }

        /** What it holds, for people. */
        public String title() {
            return title;
        }

        @Override
        public ElementType element() {
            return element;
        }
    }

    /** What a distant light gives a plane. */
    private static final Set<Column> UNIFORM_COLUMNS = EnumSet.of(Column.COSINE);
    private static final float[] ONES = ones();
    private static final float[] ZEROS = new float[TermKernel.MAX_ROWS];
    /** What a file tells of columns that stand for others there. */
    private static final int UNREACHED_FLAG = 1;
    private static final int PREMULTIPLIED_FLAG = 2;
    /** For each state and way a column that holds no other: shared by all layers of which every row has it, and not counted as memory. */
    private static final byte[][] UNIFORM_STATES = uniformStates();
    private static final float[][] WHITE_TINT = {ONES, ONES, ONES};

    /** The falloff of layers whose terms have theirs in them: 1 everywhere, shared by all of these and not counted as memory. */
    static final float[] PREMULTIPLIED = UniformColumns.of(1);

    /** All rows outside: shared by all tiles that no light in question reaches, and not counted as memory. */
    public static final LightRows UNREACHED = unlit(uniformStates(OUTSIDE_CONE));

    /** State and way of each row. */
    public final byte[] state;
    /** N·L, or the diffuse term of a metallic material; null where no row is lit. */
    public final float[] cosine;
    /** max(V·R, 0)<sup>shininess</sup>, or what F0 of a metallic material multiplies; null where no row is lit or none has any. */
    public final float[] specular;
    /** What a metallic material sends besides; null where no row is lit or none is metallic. */
    public final float[] grazing;
    /** atten·spot; null where no row is lit or the light does not fall off; {@link #PREMULTIPLIED} where the cosines have it in them. */
    public final float[] falloff;
    /** The columns of the samples seen, as many as there are for the light; null where it has one sample or no row sees any. */
    final short[][] visibleSamples;
    /** Red, green and blue columns of what passes on free ways; null where it is 1 on all. */
    final float[][] tint;
    /** How many rows are lit. */
    public final int litCount;

    private final ColumnSet<Column> columns;

    public LightRows(byte[] state, float[] cosine, float[] specular, float[] grazing, float[] falloff, int lit) {
        this(state, cosine, specular, grazing, falloff, null, lit);
    }

    public LightRows(byte[] state, float[] cosine, float[] specular, float[] grazing, float[] falloff, short[][] visibleSamples, int lit) {
        this(ColumnSet.of(Column.class, state, cosine, specular, grazing, falloff, sampleColumn(visibleSamples, 0),
                sampleColumn(visibleSamples, 1), sampleColumn(visibleSamples, 2),
                sampleColumn(visibleSamples, 3), null, null, null), lit);
    }

    LightRows(ColumnSet<Column> columns, int lit) {
        this.columns = columns;
        this.litCount = lit;
        state = (byte[]) columns.get(Column.STATE);
        cosine = (float[]) columns.get(Column.COSINE);
        specular = (float[]) columns.get(Column.SPECULAR);
        grazing = (float[]) columns.get(Column.GRAZING);
        falloff = (float[]) columns.get(Column.FALLOFF);
        visibleSamples = readVisibleSamples(columns, Column.SAMPLE_COLUMNS);
        tint = readChannels(columns, Column.TINT_COLUMNS);
    }

    /** The column of the samples from 16·{@code group} on, or null. */
    public static short[] sampleColumn(short[][] visibleSamples, int group) {
        return visibleSamples == null || visibleSamples.length <= group ? null : visibleSamples[group];
    }

    /** The columns of samples that there are, the first ones; null where there is none. */
    public static <C extends Enum<C> & ColumnKind> short[][] readVisibleSamples(ColumnSet<C> columns, List<C> kinds) {
        return !columns.has(kinds.getFirst()) ? null
                : kinds.stream().filter(columns::has).map(kind -> (short[]) columns.get(kind)).toArray(short[][]::new);
    }

    /** Three columns; null where the first is not there. */
    public static <C extends Enum<C> & ColumnKind> float[][] readChannels(ColumnSet<C> columns, List<C> channels) {
        return !columns.has(channels.getFirst()) ? null
                : channels.stream().map(channel -> (float[]) columns.get(channel)).toArray(float[][]::new);
    }

    /** Columns with others in place of three; with none where {@code colors} is null. */
    public static <C extends Enum<C> & ColumnKind> ColumnSet<C> withChannels(ColumnSet<C> columns, List<C> channels, float[][] colors) {
        ColumnSet<C> result = columns;
        for (int c = 0; c < channels.size(); c++) {
            result = result.with(channels.get(c), colors == null ? null : colors[c]);
        }
        return result;
    }

    /** Columns of which those of tints are all 1 where they are not there. */
    public static <C extends Enum<C> & ColumnKind> ColumnSet<C> withDefaultTint(ColumnSet<C> columns, List<C> channels) {
        return columns.has(channels.getFirst()) ? columns : withChannels(columns, channels, WHITE_TINT);
    }

    /**
     * The columns that layers of a light may have.
     *
     * @param metallic whether any material is metallic
     * @param tinted   whether light passes any
     */
    public static Set<Column> columns(Light light, boolean metallic, boolean tinted) {
        Set<Column> columns = EnumSet.allOf(Column.class);
        if (!tinted) {
            columns.removeAll(Column.TINT_COLUMNS);
        }
        if (!metallic) {
            columns.remove(Column.GRAZING);
        }
        columns.removeAll(Column.SAMPLE_COLUMNS.subList(sampleColumnCount(light), Column.SAMPLE_COLUMNS.size()));
        if (light.isArea()) {
            columns.remove(Column.FALLOFF);
        }
        return columns;
    }

    /** How many columns tell of the samples of a light; 0 for a point. */
    public static int sampleColumnCount(Light light) {
        return light.isArea() ? (light.area().samples() - 1) / SAMPLES_PER_COLUMN + 1 : 0;
    }

    /** A layer of which no row is lit. */
    static LightRows unlit(byte[] state) {
        return new LightRows(state, null, null, null, null, 0);
    }

    /** A layer of which no row is lit, though ways of some may be free. */
    static LightRows unlit(byte[] state, short[][] visibleSamples) {
        return new LightRows(state, null, null, null, null, visibleSamples, 0);
    }

    /** This layer with other tints, or with none where they are null. */
    public LightRows withTint(float[][] tints) {
        return tints == tint ? this : new LightRows(withChannels(columns, Column.TINT_COLUMNS, tints), litCount);
    }

    /** This layer with another column, or with none where it is null; the same rows are lit. */
    LightRows with(Column kind, float[] column) {
        return new LightRows(columns.with(kind, column), litCount);
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

    /** The bytes of a layer's columns that are counted with no layer, because all share them. */
    public static long sharedBytes(byte[] states) {
        return states == UNREACHED.state || states.length > 0 && states == UNIFORM_STATES[states[0]] ? states.length : 0;
    }

    /**
     * This layer over {@code rows} rows without what need not be kept: states or cosines of its own where all are the same, and highlights where none
     * is: adding none in place of +0 to sums that are never negative changes no bit. Grazing terms are closed beside specular ones, so
     * that where there are any both stay.
     */
    public LightRows compact(int rows) {
        ColumnSet<Column> compacted = columns.withUniform(UNIFORM_COLUMNS, rows);
        if (rows > 0 && sharedBytes(state) == 0 && Arrays.equals(state, 0, rows, UNIFORM_STATES[state[0]], 0, rows)) {
            compacted = compacted.with(Column.STATE, UNIFORM_STATES[state[0]]);
        }
        if (specular != null && grazing == null && !hasHighlight(rows)) {
            compacted = compacted.with(Column.SPECULAR, null);
        }
        return compacted == columns ? this : new LightRows(compacted, litCount);
    }

    /** Whether the cosines have the falloff in them. */
    boolean isPremultiplied() {
        return falloff == PREMULTIPLIED;
    }

    /**
     * This layer over {@code rows} rows with one column, cosine times falloff, in place of two, where no row has a highlight: the product
     * is what composing takes of both, with the same bits. New falloffs then ask for the cosines anew. The cosines are written over.
     */
    public LightRows premultiply(int rows) {
        if (falloff == null || litCount == 0 || grazing != null || specular != null && hasHighlight(rows)) {
            return this;
        }
        for (int i = 0; i < rows; i++) {
            cosine[i] *= falloff[i];
        }
        return new LightRows(columns.with(Column.SPECULAR, null).with(Column.FALLOFF, PREMULTIPLIED), litCount);
    }

    private boolean hasHighlight(int rows) {
        return !Arrays.equals(specular, 0, rows, ZEROS, 0, rows);
    }

    /** This layer over {@code rows} rows in columns of its own, {@linkplain #compact compact}. */
    public LightRows copyCompact(int rows) {
        if (state == UNREACHED.state) {
            return this;
        }
        LightRows compact = compact(rows);
        ColumnSet<Column> own = compact.columns.deepCopy(rows);
        return new LightRows(sharedBytes(compact.state) > 0 ? own.with(Column.STATE, compact.state) : own, litCount);
    }

    /** The state of a row, without the way. */
    public int state(int row) {
        return state[row] & STATE_MASK;
    }

    @Override
    public byte[] states() {
        return state;
    }

    @Override
    public short[][] visibleSamples() {
        return visibleSamples;
    }

    @Override
    public float[][] tint() {
        return tint;
    }

    @Override
    public int litCount() {
        return litCount;
    }

    /** Writes all that is known of the layer. */
    public void writeTo(ColumnWriter out) throws IOException {
        boolean unreached = state == UNREACHED.state;
        out.writeInt(litCount);
        out.writeInt(unreached ? UNREACHED_FLAG : isPremultiplied() ? PREMULTIPLIED_FLAG : 0);
        out.writeColumns(unreached ? columns.with(Column.STATE, null) : isPremultiplied() ? columns.with(Column.FALLOFF, null) : columns);
    }

    /**
     * Reads a layer.
     *
     * @throws IOException if it is cut off
     */
    public static LightRows readFrom(ColumnReader in) throws IOException {
        int lit = in.readInt();
        int shared = in.readInt();
        ColumnSet<Column> read = in.readColumns(Column.class);
        LightRows layer = new LightRows(shared == UNREACHED_FLAG ? read.with(Column.STATE, UNREACHED.state)
                : shared == PREMULTIPLIED_FLAG ? read.with(Column.FALLOFF, PREMULTIPLIED) : read, lit);
        // What was shared was written as long as that of any tile.
        return layer.compact(Math.min(layer.state.length, Math.min(length(layer.cosine), length(layer.specular))));
    }

    private static int length(float[] column) {
        return column == null ? Integer.MAX_VALUE : column.length;
    }

    /** The columns that this layer has. */
    ColumnSet<Column> columns() {
        return columns;
    }

    @Override
    public long bytes() {
        return columns.bytes() - sharedBytes(state);
    }

    /** The bytes of one kind of column. */
    public long bytes(Column kind) {
        return columns.bytes(kind) - (kind == Column.STATE ? sharedBytes(state) : 0);
    }

    @Override
    public long bytesReadByCompositing() {
        return columns.bytes() - columns.bytes(Column.STATE);
    }

    /** A new falloff needs the point alone, new terms point, normal and direction. */
    @Override
    public long rowBytesRead(LightLayer before) {
        return before instanceof LightRows b && cosine != null && b.cosine == cosine && b.state == state ? 12 : 36;
    }

    @Override
    public long newBytes(LightLayer before) {
        if (!(before instanceof LightRows b)) {
            return bytes();
        }
        return columns.newBytes(b.columns) - (state == b.state ? 0 : sharedBytes(state));
    }
}
