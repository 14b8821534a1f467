package lightning.render.shading;

import org.jspecify.annotations.Nullable;

/**
 * Operands of one of the lights' two sums, diffuse or specular, over the rows of a tile. Their order gives the bits of the tree of
 * {@link LightingEquation#sum}: two chains of lights are added up separately, then the second sum is added to the first, then known
 * sums are added.
 *
 * <p>Each chain may begin with +0: contributions are never negative, so this changes no bit. Reused; one instance per thread.
 * Columns have {@link lightning.render.trace.HitRows#paddedLength}.
 */
public final class SumOperands {
    /** Maximum number of lights in both chains; with more, a branch of the tree is added up first. */
    public static final int MAX_LIGHTS = 8;
    /** Sufficient for the depth of a tree over the maximum number of lights in a scene. */
    static final int MAX_SUMS = 12;

    private static final float[] ONES = new float[TermKernel.MAX_ROWS];

    static {
        java.util.Arrays.fill(ONES, 1);
    }

    /** Number of lights in the first chain. */
    public int firstChainLength;
    /** Number of lights in both chains. */
    public int lightCount;
    /** Each light's cosine or specular term, and its falloff. */
    public final float[][] term = new float[MAX_LIGHTS][];
    public final float[][] falloff = new float[MAX_LIGHTS][];
    /** True if any light is tinted. */
    public boolean tinted;
    /** Tints of each light; unread if no light is tinted. */
    public final float[][] tintRed = new float[MAX_LIGHTS][];
    public final float[][] tintGreen = new float[MAX_LIGHTS][];
    public final float[][] tintBlue = new float[MAX_LIGHTS][];
    /** Weight of each light. */
    public final float[] red = new float[MAX_LIGHTS];
    public final float[] green = new float[MAX_LIGHTS];
    public final float[] blue = new float[MAX_LIGHTS];
    /** Number of precomputed sums. */
    public int sumCount;
    public final float[][] sumRed = new float[MAX_SUMS][];
    public final float[][] sumGreen = new float[MAX_SUMS][];
    public final float[][] sumBlue = new float[MAX_SUMS][];

    public void clear() {
        firstChainLength = 0;
        lightCount = 0;
        sumCount = 0;
        tinted = false;
    }

    /** Returns whether the operands add up to 0. */
    public boolean isEmpty() {
        return lightCount == 0 && sumCount == 0;
    }

    /** Appends a light with the weight of one of its contributions. */
    public void addLight(LightWeight weight, float[] lightTerm, float @Nullable [] lightFalloff, float @Nullable [][] tint) {
        tinted |= tint != null;
        tintRed[lightCount] = tint == null ? ONES : tint[0];
        tintGreen[lightCount] = tint == null ? ONES : tint[1];
        tintBlue[lightCount] = tint == null ? ONES : tint[2];
        term[lightCount] = lightTerm;
        falloff[lightCount] = lightFalloff == null ? ONES : lightFalloff;
        red[lightCount] = weight.red();
        green[lightCount] = weight.green();
        blue[lightCount++] = weight.blue();
    }

    /** Ends the first chain. */
    public void endFirstChain() {
        firstChainLength = lightCount;
    }

    /** Appends a precomputed sum: red, green and blue columns. */
    public void addSum(float[][] known) {
        sumRed[sumCount] = known[0];
        sumGreen[sumCount] = known[1];
        sumBlue[sumCount++] = known[2];
    }

    /** Returns whether they are one light that has no color. */
    public boolean isGray() {
        return lightCount == 1 && sumCount == 0 && !tinted && red[0] == green[0] && red[0] == blue[0];
    }

    /** Writes the sum of rows {@code from … to − 1} of a light that has no color. */
    public void writeGray(int from, int to, float[] sum) {
        float[] lightTerm = term[0];
        float[] lightFalloff = falloff[0];
        float weight = red[0];
        for (int i = from; i < to; i++) {
            sum[i] = 0 + lightTerm[i] * lightFalloff[i] * weight;
        }
    }
}
