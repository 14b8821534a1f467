package lightning.shading;

import java.util.Arrays;

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

    /** All rows outside: shared by all tiles that no light in question reaches, and not counted as memory. */
    public static final LightRows UNREACHED = new LightRows(outside(), null, null, null, 0);

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

    public LightRows(byte[] state, float[] cosine, float[] specular, float[] falloff, int lit) {
        this.state = state;
        this.cosine = cosine;
        this.specular = specular;
        this.falloff = falloff;
        this.lit = lit;
    }

    private static byte[] outside() {
        byte[] state = new byte[LightLanes.ROWS];
        Arrays.fill(state, OUTSIDE);
        return state;
    }

    /** The bytes that states of rows take. */
    static long bytes(byte[] states) {
        return states == UNREACHED.state ? 0 : states.length;
    }

    /** The bytes that the states take. */
    public long stateBytes() {
        return bytes(state);
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

    @Override
    public long bytes() {
        return stateBytes() + 4L * (length(cosine) + length(specular) + length(falloff));
    }

    private static int length(float[] column) {
        return column == null ? 0 : column.length;
    }

    @Override
    public long newBytes(LightLayer before) {
        if (!(before instanceof LightRows b)) {
            return bytes();
        }
        return (state == b.state ? 0 : stateBytes()) + 4L * ((cosine == b.cosine ? 0 : length(cosine))
                + (specular == b.specular ? 0 : length(specular)) + (falloff == b.falloff ? 0 : length(falloff)));
    }
}
