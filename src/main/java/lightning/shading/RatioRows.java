package lightning.shading;

/**
 * One light's layer as the paper stores it (§2.4): the finished contributions, weight and falloff
 * multiplied in, which edits scale by ratios. Rows that the light does not reach hold 0; the paper's
 * negative diffuse colour, its flag for them, is the state here.
 */
public final class RatioRows implements LightLayer {
    /** No row is reached: shared, as {@link LightRows#UNREACHED}. */
    static final RatioRows UNREACHED = new RatioRows(LightRows.UNREACHED.state, null, null, 0);

    private final byte[] states;
    private final int lit;
    /** Diffuse contributions: red, green, blue columns; null where no row is lit. */
    final float[][] diffuse;
    /** Specular contributions; null where no row is lit or none is specular. */
    final float[][] specular;

    RatioRows(byte[] states, float[][] diffuse, float[][] specular, int lit) {
        this.states = states;
        this.diffuse = diffuse;
        this.specular = specular;
        this.lit = lit;
    }

    @Override
    public byte[] states() {
        return states;
    }

    @Override
    public int lit() {
        return lit;
    }

    @Override
    public long bytes() {
        return LightRows.bytes(states) + 12L * ((diffuse == null ? 0 : diffuse[0].length) + (specular == null ? 0 : specular[0].length));
    }

    /** Scaling reads every contribution and writes it anew. */
    @Override
    public long newBytes(LightLayer before) {
        return before == null ? bytes() : bytes() + before.bytes();
    }
}
