package lightning.render.shading;

/** Resolves samples to pixels: the mean, added as a balanced tree in sample order. */
public final class SampleMean {
    private SampleMean() {}

    /** Returns the mean of {@code perPixel} values from {@code from} on. */
    static float mean(float[] samples, int from, int perPixel) {
        float sum = sum(samples, from, perPixel);
        return sum <= Float.MAX_VALUE ? sum / perPixel : meanOfLarge(samples, from, perPixel);
    }

    /** Returns the mean of values whose sum overflows a float. */
    public static float meanOfLarge(float[] samples, int from, int perPixel) {
        double sum = 0;
        for (int s = from; s < from + perPixel; s++) {
            sum += samples[s];
        }
        return (float) (sum / perPixel);
    }

    /** Computes the tree of {@link LightingEquation#sum}; adds four leaves at a time, which takes a third of the time. */
    private static float sum(float[] v, int from, int count) {
        return switch (count) {
            case 1 -> v[from];
            case 2 -> v[from] + v[from + 1];
            case 3 -> sumThree(v, from);
            case 4 -> sumFour(v, from);
            case 5 -> v[from] + v[from + 1] + sumThree(v, from + 2);
            case 12 -> sumThree(v, from) + sumThree(v, from + 3) + (sumThree(v, from + 6) + sumThree(v, from + 9));
            case 16 -> sumFour(v, from) + sumFour(v, from + 4) + (sumFour(v, from + 8) + sumFour(v, from + 12));
            default -> sum(v, from, count >>> 1) + sum(v, from + (count >>> 1), count - (count >>> 1));
        };
    }

    private static float sumThree(float[] v, int from) {
        return v[from] + (v[from + 1] + v[from + 2]);
    }

    private static float sumFour(float[] v, int from) {
        return v[from] + v[from + 1] + (v[from + 2] + v[from + 3]);
    }

    /**
     * Writes the means of the pixels of a block.
     *
     * @param samples red, green and blue columns: the samples of the first pixel, then of the next
     * @return red, green and blue, {@code float[pixels]} each
     */
    public static float[][] ofPixels(int pixels, int perPixel, float[][] samples) {
        float[][] means = new float[3][pixels];
        for (int c = 0; c < 3; c++) {
            for (int i = 0; i < pixels; i++) {
                means[c][i] = mean(samples[c], i * perPixel, perPixel);
            }
        }
        return means;
    }

    /** Returns the mean of all samples of a pixel from the means of two groups of them. */
    public static float combine(float first, int firstCount, float rest, int restCount) {
        int count = firstCount + restCount;
        // The shares may add up to slightly more than 1.
        return Math.min(first * ((float) firstCount / count) + rest * ((float) restCount / count), Float.MAX_VALUE);
    }

    /** Returns the number of pixels with {@code perPixel} samples each that are traced together. */
    public static int pixelsPerBatch(int perPixel) {
        return TermKernel.MAX_ROWS / perPixel;
    }
}
