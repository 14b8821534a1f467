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
    static float meanOfLarge(float[] samples, int from, int perPixel) {
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
            case 3 -> v[from] + (v[from + 1] + v[from + 2]);
            case 4 -> sumFour(v, from);
            case 16 -> sumFour(v, from) + sumFour(v, from + 4) + (sumFour(v, from + 8) + sumFour(v, from + 12));
            default -> sum(v, from, count >>> 1) + sum(v, from + (count >>> 1), count - (count >>> 1));
        };
    }

    private static float sumFour(float[] v, int from) {
        return v[from] + v[from + 1] + (v[from + 2] + v[from + 3]);
    }

    /**
     * Writes some pixels of a tile.
     *
     * @param pixels  indices in the tile; those from {@code from} to before {@code to} are written
     * @param samples red, green and blue columns: the samples of the first of these pixels, then of the next
     * @param film    red, green and blue of the tile
     */
    public static void write(short[] pixels, int from, int to, int perPixel, float[][] samples, float[][] film) {
        for (int c = 0; c < 3; c++) {
            for (int i = from; i < to; i++) {
                film[c][pixels[i]] = mean(samples[c], (i - from) * perPixel, perPixel);
            }
        }
    }

    /** Returns the number of pixels with {@code perPixel} samples each that are traced together. */
    public static int pixelsPerBatch(int perPixel) {
        return TermKernel.MAX_ROWS / perPixel;
    }
}
