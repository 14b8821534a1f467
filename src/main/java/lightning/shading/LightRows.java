package lightning.shading;

import java.util.Arrays;
import lightning.column.ColumnKind;
import lightning.column.ColumnSet;
import lightning.column.Element;

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
    public static final byte AWAY = 0;
    public static final byte OUTSIDE = 1;
    public static final byte SHADOWED = 2;
    public static final byte LIT = 3;
    public static final int STATE = 3;
    /** Whether the way to the light is free, as far as known; kept apart from the state. */
    public static final int CLEAR = 4;
    public static final int BLOCKED = 8;

    /** All columns that there are: what makes, counts and splices layers knows no others. */
    public enum Column implements ColumnKind {
        STATE(Element.BYTE),
        COSINE(Element.FLOAT),
        SPECULAR(Element.FLOAT),
        FALLOFF(Element.FLOAT);

        private final Element element;

        Column(Element element) {
            this.element = element;
        }

        @Override
        public Element element() {
            return element;
        }
    }

    /** All rows outside: shared by all tiles that no light in question reaches, and not counted as memory. */
    public static final LightRows UNREACHED = unlit(outside());

    /** State and way of each row. */
    public final byte[] state;
    /** N·L; null where no row is lit. */
    public final float[] cosine;
    /** max(V·R, 0)<sup>shininess</sup>; null where no row is lit or none is specular. */
    public final float[] specular;
    /** atten·spot; null where no row is lit or the light does not fall off. */
    public final float[] falloff;
    /** How many rows are lit. */
    public final int lit;

    private final ColumnSet<Column> columns;

    public LightRows(byte[] state, float[] cosine, float[] specular, float[] falloff, int lit) {
        this(ColumnSet.of(Column.class, state, cosine, specular, falloff), lit);
    }

    LightRows(ColumnSet<Column> columns, int lit) {
        this.columns = columns;
        this.lit = lit;
        state = (byte[]) columns.get(Column.STATE);
        cosine = (float[]) columns.get(Column.COSINE);
        specular = (float[]) columns.get(Column.SPECULAR);
        falloff = (float[]) columns.get(Column.FALLOFF);
    }

    /** A layer of which no row is lit. */
    static LightRows unlit(byte[] state) {
        return new LightRows(state, null, null, null, 0);
    }

    /** This layer with another column, or with none where it is null; the same rows are lit. */
    LightRows with(Column kind, float[] column) {
        return new LightRows(columns.with(kind, column), lit);
    }

    private static byte[] outside() {
        byte[] state = new byte[Terms.ROWS];
        Arrays.fill(state, OUTSIDE);
        return state;
    }

    /** The bytes of a layer's columns that are counted with no layer, because all share them. */
    static long shared(byte[] states) {
        return states == UNREACHED.state ? states.length : 0;
    }

    /** The state of a row, without the way. */
    public int state(int row) {
        return state[row] & STATE;
    }

    @Override
    public byte[] states() {
        return state;
    }

    @Override
    public int lit() {
        return lit;
    }

    /** The columns that this layer has. */
    ColumnSet<Column> columns() {
        return columns;
    }

    @Override
    public long bytes() {
        return columns.bytes() - shared(state);
    }

    /** The bytes of one kind of column. */
    public long bytes(Column kind) {
        return columns.bytes(kind) - (kind == Column.STATE ? shared(state) : 0);
    }

    @Override
    public long newBytes(LightLayer before) {
        if (!(before instanceof LightRows b)) {
            return bytes();
        }
        return columns.newBytes(b.columns) - (state == b.state ? 0 : shared(state));
    }
}
