package lightning.format.layer;

/**
 * How layers are added: as floats, each to the sum of those before, red, green and blue for themselves. As every surface's color is
 * rounded once for all lights, and a pixel's samples are rounded too, no order of a sum of layers gives the picture in every bit; what is
 * missing is a layer of its own, the last.
 *
 * <p>It is exact: all layers are at least 0, so that sum and picture differ by a few roundings of their size, and the difference of two
 * floats of which none is more than twice the other is a float (Sterbenz, Floating-Point Computation, 1974, theorem 4.3.1). So small ones
 * that their products underflow are multiples of the least float, and so is their difference.
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

    /** What must be added to make the picture of the sum. */
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
