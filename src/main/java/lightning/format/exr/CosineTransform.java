package lightning.format.exr;

/** Orthonormal cosine transform of 8 × 8 values, and the order in which DWA stores its results: from low frequencies to high ones. */
final class CosineTransform {
    private static final int SIDE = DwaLayout.SIDE;
    /** Value of each frequency, the row, at each place. */
    private static final float[] BASIS = basis();
    private static final float[] TRANSPOSED_BASIS = transposedBasis();
    /** Index, line by line, of each stored value: along diagonals, in turns up and down. */
    private static final int[] DIAGONALS = diagonals();

    private CosineTransform() {}

    private static float[] basis() {
        float[] basis = new float[DwaLayout.BLOCK];
        for (int frequency = 0; frequency < SIDE; frequency++) {
            for (int place = 0; place < SIDE; place++) {
                basis[frequency * SIDE + place] = (float) (Math.cos(Math.PI * frequency * (2 * place + 1) / (2 * SIDE))
                        * Math.sqrt((frequency == 0 ? 1.0 : 2.0) / SIDE));
            }
        }
        return basis;
    }

    private static float[] transposedBasis() {
        float[] transposed = new float[DwaLayout.BLOCK];
        for (int i = 0; i < transposed.length; i++) {
            transposed[i % SIDE * SIDE + i / SIDE] = BASIS[i];
        }
        return transposed;
    }

    private static int[] diagonals() {
        int[] order = new int[DwaLayout.BLOCK];
        int n = 0;
        for (int diagonal = 0; diagonal < 2 * SIDE - 1; diagonal++) {
            for (int i = Math.max(0, diagonal - SIDE + 1); i <= Math.min(diagonal, SIDE - 1); i++) {
                int across = diagonal % 2 == 0 ? i : diagonal - i;
                order[n++] = (diagonal - across) * SIDE + across;
            }
        }
        return order;
    }

    /** Returns the index, line by line, of stored value {@code n}. */
    static int index(int n) {
        return DIAGONALS[n];
    }

    /** Replaces values by their frequencies. */
    static void transform(float[] values) {
        multiply(values, BASIS);
    }

    /** Replaces frequencies by the values. */
    static void invert(float[] frequencies) {
        multiply(frequencies, TRANSPOSED_BASIS);
    }

    /** Replaces values by M·V·Mᵀ, where M is a matrix. */
    private static void multiply(float[] values, float[] matrix) {
        float[] half = new float[DwaLayout.BLOCK];
        multiplyAndTranspose(values, matrix, half);
        multiplyAndTranspose(half, matrix, values);
    }

    /** Writes M·Vᵀ, where M is a matrix and V are values. */
    private static void multiplyAndTranspose(float[] values, float[] matrix, float[] to) {
        for (int row = 0; row < SIDE; row++) {
            for (int line = 0; line < SIDE; line++) {
                float sum = 0;
                for (int i = 0; i < SIDE; i++) {
                    sum += matrix[row * SIDE + i] * values[line * SIDE + i];
                }
                to[row * SIDE + line] = sum;
            }
        }
    }
}
