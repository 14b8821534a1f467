package lightning.format.exr;

/** Orthonormal cosine transform of 8 × 8 values, and the order in which DWA stores its results: from low frequencies to high ones. */
final class CosineTransform {
    private static final int SIDE = DwaLayout.SIDE;
    /** Value of each frequency, the row, at each place. */
    private static final float[] BASIS = basis();
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
        float[] across = new float[DwaLayout.BLOCK];
        for (int y = 0; y < SIDE; y++) {
            for (int f = 0; f < SIDE; f++) {
                float sum = 0;
                for (int x = 0; x < SIDE; x++) {
                    sum += BASIS[f * SIDE + x] * values[y * SIDE + x];
                }
                across[y * SIDE + f] = sum;
            }
        }
        for (int f = 0; f < SIDE; f++) {
            for (int x = 0; x < SIDE; x++) {
                float sum = 0;
                for (int y = 0; y < SIDE; y++) {
                    sum += BASIS[f * SIDE + y] * across[y * SIDE + x];
                }
                values[f * SIDE + x] = sum;
            }
        }
    }

    /** Replaces frequencies by the values. */
    static void invert(float[] frequencies) {
        float[] across = new float[DwaLayout.BLOCK];
        for (int f = 0; f < SIDE; f++) {
            for (int x = 0; x < SIDE; x++) {
                float sum = 0;
                for (int g = 0; g < SIDE; g++) {
                    sum += BASIS[g * SIDE + x] * frequencies[f * SIDE + g];
                }
                across[f * SIDE + x] = sum;
            }
        }
        for (int y = 0; y < SIDE; y++) {
            for (int x = 0; x < SIDE; x++) {
                float sum = 0;
                for (int f = 0; f < SIDE; f++) {
                    sum += BASIS[f * SIDE + y] * across[f * SIDE + x];
                }
                frequencies[y * SIDE + x] = sum;
            }
        }
    }
}
