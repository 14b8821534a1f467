package lightning.render.relight.paper;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import lightning.render.column.ColumnKind;
import lightning.render.column.ColumnSet;
import lightning.render.column.ElementType;
import lightning.render.shading.layer.LightLayer;
import lightning.render.shading.layer.LightRows;
import lightning.render.shading.layer.WeightedLayer;
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;

/**
 * Layer of one light as the paper stores it (§2.4): finished contributions, including weight and falloff, which edits scale by
 * ratios. Rows that the light does not reach hold 0. The state column replaces the paper's flag for them, a negative diffuse color.
 */
public final class RatioRows extends WeightedLayer {
    /** Columns of a layer. All code that creates, counts and splices layers uses this list. */
    enum Column implements ColumnKind {
        STATE(ElementType.BYTE),
        DIFFUSE_RED(ElementType.FLOAT),
        DIFFUSE_GREEN(ElementType.FLOAT),
        DIFFUSE_BLUE(ElementType.FLOAT),
        SPECULAR_RED(ElementType.FLOAT),
        SPECULAR_GREEN(ElementType.FLOAT),
        SPECULAR_BLUE(ElementType.FLOAT),
        GRAZING_RED(ElementType.FLOAT),
        GRAZING_GREEN(ElementType.FLOAT),
        GRAZING_BLUE(ElementType.FLOAT),
        SEEN_0(ElementType.SHORT),
        SEEN_1(ElementType.SHORT),
        SEEN_2(ElementType.SHORT),
        SEEN_3(ElementType.SHORT),
        TINT_RED(ElementType.FLOAT),
        TINT_GREEN(ElementType.FLOAT),
        TINT_BLUE(ElementType.FLOAT);

        static final List<Column> DIFFUSE_COLUMNS = List.of(DIFFUSE_RED, DIFFUSE_GREEN, DIFFUSE_BLUE);
        static final List<Column> SAMPLE_COLUMNS = List.of(SEEN_0, SEEN_1, SEEN_2, SEEN_3);
        static final List<Column> TINT_COLUMNS = List.of(TINT_RED, TINT_GREEN, TINT_BLUE);
        static final List<Column> GRAZING_COLUMNS = List.of(GRAZING_RED, GRAZING_GREEN, GRAZING_BLUE);
        static final List<Column> SPECULAR_COLUMNS = List.of(SPECULAR_RED, SPECULAR_GREEN, SPECULAR_BLUE);

        private final ElementType element;

        Column(ElementType element) {
            this.element = element;
        }

        @Override
        public ElementType element() {
            return element;
        }
    }

    /** Shared layer without a reached row, like {@link LightRows#UNREACHED}. */
    static final RatioRows UNREACHED = new RatioRows(LightRows.UNREACHED.state, null, null, null, null, 0);

    private final byte[] states;
    private final int litCount;
    /** Visible light samples of each row; see {@link LightRows#visibleSamples}. */
    private final short @Nullable [][] visibleSamples;

    /** Tints of unblocked shadow rays, included in the contributions; see {@link LightRows#tint}. */
    private final float @Nullable [][] tint;

    private final ColumnSet<Column> columns;

    RatioRows(byte[] states, float @Nullable [][] diffuse, float @Nullable [][] specular, float @Nullable [][] grazing,
            short @Nullable [][] visibleSamples, int lit) {
        this(ColumnSet.of(Column.class, states, channel(diffuse, 0), channel(diffuse, 1), channel(diffuse, 2), channel(specular, 0),
                channel(specular, 1), channel(specular, 2), channel(grazing, 0), channel(grazing, 1), channel(grazing, 2),
                LightRows.sampleColumn(visibleSamples, 0), LightRows.sampleColumn(visibleSamples, 1),
                LightRows.sampleColumn(visibleSamples, 2), LightRows.sampleColumn(visibleSamples, 3), null, null, null), lit);
    }

    RatioRows(ColumnSet<Column> columns, int lit) {
        super(LightRows.readChannels(columns, Column.DIFFUSE_COLUMNS), LightRows.readChannels(columns, Column.SPECULAR_COLUMNS),
                LightRows.readChannels(columns, Column.GRAZING_COLUMNS));
        this.columns = columns;
        this.litCount = lit;
        states = (byte[]) columns.get(Column.STATE);
        tint = LightRows.readChannels(columns, Column.TINT_COLUMNS);
        visibleSamples = LightRows.readVisibleSamples(columns, Column.SAMPLE_COLUMNS);
    }

    /**
     * Returns the columns that layers of a light may have.
     *
     * @param metallic true if any material is metallic
     * @param tinted   true if light passes through any material
     */
    static Set<Column> columns(Light light, boolean metallic, boolean tinted) {
        Set<Column> columns = EnumSet.allOf(Column.class);
        if (!tinted) {
            columns.removeAll(Column.TINT_COLUMNS);
        }
        if (!metallic) {
            columns.removeAll(Column.GRAZING_COLUMNS);
        }
        columns.removeAll(Column.SAMPLE_COLUMNS.subList(LightRows.sampleColumnCount(light), Column.SAMPLE_COLUMNS.size()));
        return columns;
    }

    @Override
    public boolean isUnreached() {
        return states == UNREACHED.states;
    }

    private static float @Nullable [] channel(float @Nullable [][] colors, int c) {
        return colors == null ? null : colors[c];
    }

    /** Returns this layer with these tints, which its contributions include; null for none. */
    RatioRows withTint(float @Nullable [][] tints) {
        return tints == tint ? this : new RatioRows(LightRows.withChannels(columns, Column.TINT_COLUMNS, tints), litCount);
    }

    @Override
    public byte[] states() {
        return states;
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

    /** Returns the columns of this layer. */
    ColumnSet<Column> columns() {
        return columns;
    }

    @Override
    public long bytes() {
        return columns.bytes() - LightRows.sharedBytes(states);
    }

    @Override
    public long bytesReadByCompositing() {
        return columns.bytes() - columns.bytes(Column.STATE);
    }

    /** New falloffs need only the point; new terms need point, normal and direction. */
    @Override
    public long rowBytesRead(@Nullable LightLayer before) {
        return before != null && before.states() == states ? 12 : 36;
    }

    /** Scaling reads and writes every contribution. */
    @Override
    public long newBytes(@Nullable LightLayer before) {
        return before == null ? bytes() : bytes() + before.bytes();
    }
}
