package lightning.format.exr;

/**
 * Two-dimensional Haar wavelet of 16-bit numbers. Each step restores pairs from their mean and difference, from coarse to fine.
 *
 * @param numbers all numbers; changed in place
 * @param isSmall whether no sum overflows, so that means and differences are signed; otherwise they are modulo 65536
 */
record HaarWavelet(short[] numbers, boolean isSmall) {
    /** Numbers below this have sums that do not overflow. */
    private static final int SMALL = 1 << 14;
    private static final int OFFSET = 1 << 15;

    /**
     * Decodes a grid of numbers in place.
     *
     * @param start index of the first number
     * @param columns numbers in a line, {@code stepX} indices apart
     * @param rows lines, {@code stepY} indices apart
     * @param max largest decoded number
     */
    static void decode(short[] numbers, int start, int columns, int stepX, int rows, int stepY, int max) {
        var wavelet = new HaarWavelet(numbers, max < SMALL);
        for (int size = Integer.highestOneBit(Math.min(columns, rows)) / 2; size >= 1; size /= 2) {
            int y = start;
            for (int row = 0; row + 2 * size <= rows; row += 2 * size, y += 2 * size * stepY) {
                int x = y;
                for (int column = 0; column + 2 * size <= columns; column += 2 * size, x += 2 * size * stepX) {
                    wavelet.restoreSquare(x, size * stepX, size * stepY);
                }
                if ((columns & size) != 0) {
                    wavelet.restore(x, x + size * stepY);
                }
            }
            if ((rows & size) != 0) {
                for (int column = 0; column + 2 * size <= columns; column += 2 * size) {
                    wavelet.restore(y + column * stepX, y + (column + size) * stepX);
                }
            }
        }
    }

    private void restoreSquare(int a, int right, int below) {
        restore(a, a + below);
        restore(a + right, a + right + below);
        restore(a, a + right);
        restore(a + below, a + below + right);
    }

    /** Replaces the mean at {@code i} and the difference at {@code j} by the two numbers. */
    private void restore(int i, int j) {
        if (isSmall) {
            int difference = numbers[j];
            int first = numbers[i] + (difference & 1) + (difference >> 1);
            numbers[i] = (short) first;
            numbers[j] = (short) (first - difference);
        } else {
            int difference = Short.toUnsignedInt(numbers[j]);
            int second = Short.toUnsignedInt(numbers[i]) - (difference >> 1);
            numbers[j] = (short) second;
            numbers[i] = (short) (difference + second - OFFSET);
        }
    }
}
