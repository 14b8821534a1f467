package lightning.layer;

/**
 * Sum of layers in 32-bit floats, separately for red, green and blue. Since the renderer rounds a surface's color once for
 * all lights, and pixels of several samples once more, no summation order reproduces the image exactly; the residual is a
 * separate last layer.
 *
 * <p>The residual is exact: all layers are at least 0, so that sum and image differ only by a few roundings, and the
 * difference of two floats within a factor of two is a float (Sterbenz, Floating-Point Computation, 1974, theorem 4.3.1).
 * Values whose products underflow are multiples of the smallest float, and so is their difference.
 */
final class LayerSum {
    private final float[][] sum;

    LayerSum(int pixels) {
        sum = new float[3][pixels];
    }

    /** Adds a layer: red, green, blue. */
    void add(float[][] layer) {
        for (int c = 0; c < 3; c++) {
            for (int i = 0; i < sum[c].length; i++) {
                sum[c][i] += layer[c][i];
            }
        }
    }

    /** Returns the residual that must be added to the sum to obtain the image. */
    float[][] residual(float[][] picture) {
        float[][] residual = new float[3][sum[0].length];
        for (int c = 0; c < 3; c++) {
            for (int i = 0; i < residual[c].length; i++) {
                residual[c][i] = picture[c][i] - sum[c][i];
            }
        }
        return residual;
    }
}
