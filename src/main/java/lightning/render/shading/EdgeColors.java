package lightning.render.shading;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * Colors of a tile's pixel centers, or of the first samples of some pixels, by which anti-aliasing decides where it needs more
 * samples. They are the sum of the picture's films with rounded weights ({@link FilmParts#edgeWeights}).
 *
 * @param colors packed colors, one for each position ({@link #pack})
 * @param images colors of the rays that bounce from the first level's rows; null if there are none
 */
public record EdgeColors(int[] colors, @Nullable BounceImages images) {
    // An array in a record: written once by its creator.

    private static final int BITS = 10;
    private static final int MASK = (1 << BITS) - 1;
    /** Steps of a packed channel from black to white. */
    private static final int STEPS = 511;
    /** Values above this, 4 times white, count as this. */
    private static final float MAX_VALUE = 4;
    /** Largest invisible step between neighboring pixels, in steps of a packed channel. */
    private static final int MAX_NEIGHBOR_STEP = 20;
    /** Largest step between samples of a pixel that their mean hides. */
    private static final int MAX_SAMPLE_STEP = 48;

    /** Packs the linear colors of the first positions of a tile. */
    public static int[] pack(float[][] linear, int positions) {
        int[] packed = new int[positions];
        for (int i = 0; i < packed.length; i++) {
            packed[i] = pack(linear[0][i], linear[1][i], linear[2][i]);
        }
        return packed;
    }

    /** Returns a color as three numbers of 10 bits, each proportional to the square root of a channel: steps look equally large. */
    public static int pack(float red, float green, float blue) {
        return (step(red) << BITS | step(green)) << BITS | step(blue);
    }

    private static int step(float value) {
        return (int) (Math.sqrt(Math.min(value, MAX_VALUE)) * STEPS + 0.5);
    }

    /** Returns whether the step between the packed colors of two neighboring pixels is visible. */
    public static boolean differ(int a, int b) {
        return a != b
                && (isStep(a >>> 2 * BITS, b >>> 2 * BITS) || isStep(a >>> BITS & MASK, b >>> BITS & MASK) || isStep(a & MASK, b & MASK));
    }

    private static boolean isStep(int a, int b) {
        return Math.abs(a - b) > MAX_NEIGHBOR_STEP;
    }

    /** Returns whether some samples of a pixel differ so much that it needs more. */
    public static boolean needMore(int[] packed, int from, int count) {
        for (int shift = 0; shift <= 2 * BITS; shift += BITS) {
            int min = MASK;
            int max = 0;
            for (int i = from; i < from + count; i++) {
                int step = packed[i] >>> shift & MASK;
                min = Math.min(min, step);
                max = Math.max(max, step);
            }
            if (max - min > MAX_SAMPLE_STEP) {
                return true;
            }
        }
        return false;
    }

    /** Returns {@code known} if its colors are equal, so that later comparisons can compare references. */
    public EdgeColors reuseIfEqual(@Nullable EdgeColors known) {
        return known != null && Arrays.equals(colors, known.colors) ? new EdgeColors(known.colors, images) : this;
    }

    /** Returns the bytes of the arrays. */
    public long bytes() {
        return 4L * colors.length + (images == null ? 0 : images.bytes());
    }
}
