package lightning.render.shading;

/**
 * What adds up to one of the lights' two sums, diffuse or specular, over the rows of a tile, in an order that gives the bits of
 * the tree of {@link LightingEquation#sum}: lights in two chains, each added up by itself, then the second chain's sum to the
 * first's, then sums that are known.
 *
 * <p>Each chain may begin with +0: contributions are never negative, so that it changes no bit. Reused; one for each thread.
 * Columns are as long as {@link lightning.render.trace.HitRows#paddedLength}.
 */
public final class SumOperands {
    /** The lights of both chains at most: with more, one of the tree's branches is added up before. */
    static final int MAX_LIGHTS = 8;
    /** Enough for the depth of a tree over the most lights that a scene may have. */
    static final int MAX_SUMS = 12;

    private static final float[] ONES = new float[TermKernel.MAX_ROWS];

    static {
        java.util.Arrays.fill(ONES, 1);
    }

    /** Lights in the first chain. */
    public int firstChainLength;
    /** Lights in both chains. */
    public int lightCount;
    /** Each light's cosine or specular term, and its falloff. */
    public final float[][] term = new float[MAX_LIGHTS][];
    public final float[][] falloff = new float[MAX_LIGHTS][];
    /** Whether any light has tints. */
    public boolean tinted;
    /** What passes of each light; unread where none has tints. */
    public final float[][] tintRed = new float[MAX_LIGHTS][];
    public final float[][] tintGreen = new float[MAX_LIGHTS][];
    public final float[][] tintBlue = new float[MAX_LIGHTS][];
    /** Each light's weight. */
    public final float[] red = new float[MAX_LIGHTS];
    public final float[] green = new float[MAX_LIGHTS];
    public final float[] blue = new float[MAX_LIGHTS];
    /** Sums that are known. */
    public int sumCount;
    public final float[][] sumRed = new float[MAX_SUMS][];
    public final float[][] sumGreen = new float[MAX_SUMS][];
    public final float[][] sumBlue = new float[MAX_SUMS][];

    void clear() {
        firstChainLength = 0;
        lightCount = 0;
        sumCount = 0;
        tinted = false;
    }

    /** Whether they add up to 0. */
    boolean isEmpty() {
        return lightCount == 0 && sumCount == 0;
    }

    /** Puts a light behind the others. */
    void addLight(WeightedLight light, float[] lightTerm, float[] lightFalloff, float[][] tint) {
        tinted |= tint != null;
        tintRed[lightCount] = tint == null ? ONES : tint[0];
        tintGreen[lightCount] = tint == null ? ONES : tint[1];
        tintBlue[lightCount] = tint == null ? ONES : tint[2];
        term[lightCount] = lightTerm;
        falloff[lightCount] = lightFalloff == null ? ONES : lightFalloff;
        red[lightCount] = light.red();
        green[lightCount] = light.green();
        blue[lightCount++] = light.blue();
    }

    /** Ends the first chain. */
    void endFirstChain() {
        firstChainLength = lightCount;
    }

    /** Puts a known sum behind the others: red, green and blue columns. */
    void addSum(float[][] known) {
        sumRed[sumCount] = known[0];
        sumGreen[sumCount] = known[1];
        sumBlue[sumCount++] = known[2];
    }
}
