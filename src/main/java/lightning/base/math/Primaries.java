package lightning.base.math;

/**
 * Chromaticities (CIE 1931) of an RGB color space.
 *
 * @param xy    {@code double[6]}: x and y of red, green and blue
 * @param white {@code double[2]}: x and y of the color (1, 1, 1)
 */
public record Primaries(double[] xy, double[] white) {
    // Arrays in a record: written once by their creator, never after.

    private static final double[] ACES_WHITE = {0.32168, 0.33767};
    /** ACES2065-1 (SMPTE ST 2065-1). */
    public static final Primaries AP0 = new Primaries(new double[] {0.7347, 0.2653, 0, 1, 0.0001, -0.077}, ACES_WHITE);
    /** ACEScg (Academy S-2014-004). */
    public static final Primaries AP1 = new Primaries(new double[] {0.713, 0.293, 0.165, 0.83, 0.128, 0.044}, ACES_WHITE);
    /** Rec. 709 and sRGB (ITU-R BT.709), with D65. */
    public static final Primaries REC709 = new Primaries(new double[] {0.64, 0.33, 0.3, 0.6, 0.15, 0.06}, new double[] {0.3127, 0.329});

    /** Cone responses of Bradford, from XYZ (Lam, 1985; ICC.1, annex E). */
    private static final Matrix3 BRADFORD =
            Matrix3.of(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296);

    /** Returns the matrix from RGB to XYZ, by which (1, 1, 1) has Y = 1 (SMPTE RP 177). */
    public Matrix3 toXyz() {
        double[] columns = new double[9];
        for (int c = 0; c < 3; c++) {
            double x = xy[2 * c];
            double y = xy[2 * c + 1];
            columns[c] = x;
            columns[3 + c] = y;
            columns[6 + c] = 1 - x - y;
        }
        Matrix3 unscaled = new Matrix3(columns);
        return unscaled.scaleColumns(unscaled.inverse().times(whiteXyz()));
    }

    private double[] whiteXyz() {
        return new double[] {white[0] / white[1], 1, (1 - white[0] - white[1]) / white[1]};
    }

    /** Returns the matrix to another space, so that white becomes white: an adaptation of Bradford's cone responses (von Kries). */
    public Matrix3 to(Primaries other) {
        double[] from = BRADFORD.times(whiteXyz());
        double[] to = BRADFORD.times(other.whiteXyz());
        Matrix3 adaptation =
                BRADFORD.inverse().after(BRADFORD.scaleRows(to[0] / from[0], to[1] / from[1], to[2] / from[2]));
        return other.toXyz().inverse().after(adaptation).after(toXyz());
    }
}
