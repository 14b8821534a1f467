package lightning.editor.window.model;

/** Scales a coarse picture up to the size of the picture being traced. */
final class CoarseScaling {
    /** Unit of weights: 8 bits, so that the product of two weights and a channel fits an int. */
    private static final int ONE = 256;
    private static final int CHANNEL = 0xFF;

    private CoarseScaling() {}

    /**
     * Interpolates linearly between the centers of the coarse pixels, in display values: light ones do not spread over dark ones. Beyond the
     * outermost centers, their values stay.
     *
     * @param from {@code int[fromWidth * fromHeight]}, opaque
     * @param to {@code int[width * height]}
     */
    static void smooth(int[] from, int fromWidth, int fromHeight, int[] to, int width, int height) {
        int[] left = new int[width];
        int[] share = new int[width];
        for (int x = 0; x < width; x++) {
            int position = position(x, width, fromWidth);
            left[x] = position / ONE;
            share[x] = position % ONE;
        }
        for (int y = 0; y < height; y++) {
            int position = position(y, height, fromHeight);
            int above = position / ONE * fromWidth;
            int below = Math.min(position / ONE + 1, fromHeight - 1) * fromWidth;
            int lower = position % ONE;
            for (int x = 0; x < width; x++) {
                int next = Math.min(left[x] + 1, fromWidth - 1);
                int a = mix(from[above + left[x]], from[above + next], share[x]);
                int b = mix(from[below + left[x]], from[below + next], share[x]);
                to[y * width + x] = mix(a, b, lower);
            }
        }
    }

    /** Repeats each coarse pixel: for pictures whose colors stand for values. */
    static void repeat(int[] from, int fromWidth, int fromHeight, int[] to, int width, int height) {
        for (int y = 0; y < height; y++) {
            int line = (int) ((long) y * fromHeight / height) * fromWidth;
            for (int x = 0; x < width; x++) {
                to[y * width + x] = from[line + (int) ((long) x * fromWidth / width)];
            }
        }
    }

    /** Returns the position of a pixel's center between coarse centers, in units of 1 / {@value #ONE}. */
    private static int position(int pixel, int size, int coarseSize) {
        long center = (2L * pixel + 1) * coarseSize * ONE / (2L * size) - ONE / 2;
        return (int) Math.clamp(center, 0, (coarseSize - 1L) * ONE);
    }

    private static int mix(int a, int b, int share) {
        if (a == b || share == 0) {
            return a;
        }
        int red = channel(a >> 16 & CHANNEL, b >> 16 & CHANNEL, share);
        int green = channel(a >> 8 & CHANNEL, b >> 8 & CHANNEL, share);
        int blue = channel(a & CHANNEL, b & CHANNEL, share);
        return a & CHANNEL << 24 | red << 16 | green << 8 | blue;
    }

    private static int channel(int a, int b, int share) {
        return (a * (ONE - share) + b * share + ONE / 2) / ONE;
    }
}
