package lightning.render.shading;

/**
 * What adds up to one of the lights' two sums, diffuse or specular, over the rows of a tile, in an order that gives the bits of
 * the tree of {@link LightingEquation#sum}: lights in two chains, each added up by itself, then the second chain's sum to the
 * first's, then sums that are known.
 *
 * <p>Each chain may begin with +0: contributions are never negative, so that it changes no bit. Reused; one for each thread.
 * Columns are as long as {@link lightning.render.trace.HitRows#padded}.
 */
public final class Addends {
    /** The lights of both chains at most: with more, one of the tree's branches is added up before. */
    static final int MOST_LIGHTS = 8;
    /** Enough for the depth of a tree over the most lights that a scene may have. */
    static final int MOST_SUMS = 12;

    private static final float[] ONES = new float[Terms.ROWS];

    static {
        java.util.Arrays.fill(ONES, 1);
    }

    /** Lights in the first chain. */
    public int first;
    /** Lights in both chains. */
    public int lights;
    /** Each light's cosine or specular term, and its falloff. */
    public final float[][] term = new float[MOST_LIGHTS][];
    public final float[][] falloff = new float[MOST_LIGHTS][];
    /** Whether any light has tints. */
    public boolean tinted;
    /** What passes of each light; unread where none has tints. */
    public final float[][] tintRed = new float[MOST_LIGHTS][];
    public final float[][] tintGreen = new float[MOST_LIGHTS][];
    public final float[][] tintBlue = new float[MOST_LIGHTS][];
    /** Each light's weight. */
    public final float[] red = new float[MOST_LIGHTS];
    public final float[] green = new float[MOST_LIGHTS];
    public final float[] blue = new float[MOST_LIGHTS];
    /** Sums that are known. */
    public int sums;
    public final float[][] sumRed = new float[MOST_SUMS][];
    public final float[][] sumGreen = new float[MOST_SUMS][];
    public final float[][] sumBlue = new float[MOST_SUMS][];

    void clear() {
        first = 0;
        lights = 0;
        sums = 0;
        tinted = false;
    }

    /** Whether they add up to 0. */
    boolean isEmpty() {
        return lights == 0 && sums == 0;
    }

    /** Puts a light behind the others. */
    void light(Luminaire light, float[] lightTerm, float[] lightFalloff, float[][] tint) {
        tinted |= tint != null;
        tintRed[lights] = tint == null ? ONES : tint[0];
        tintGreen[lights] = tint == null ? ONES : tint[1];
        tintBlue[lights] = tint == null ? ONES : tint[2];
        term[lights] = lightTerm;
        falloff[lights] = lightFalloff == null ? ONES : lightFalloff;
        red[lights] = light.red();
        green[lights] = light.green();
        blue[lights++] = light.blue();
    }

    /** Ends the first chain. */
    void second() {
        first = lights;
    }

    /** Puts a known sum behind the others: red, green and blue columns. */
    void sum(float[][] known) {
        sumRed[sums] = known[0];
        sumGreen[sums] = known[1];
        sumBlue[sums++] = known[2];
    }
}
