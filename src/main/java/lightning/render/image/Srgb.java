package lightning.render.image;

import lightning.base.math.SrgbCurve;

/**
 * sRGB encoding to and from 8 bits (IEC 61966-2-1), correctly rounded.
 *
 * <p>For a linear value v in 0…1 the code is {@code round(255 · s)}, where {@code s = 12.92 · v} up to v = 0.0031308 and {@code s =
 * 1.055 · v^(1/2.4) − 0.055} above. {@link #formula} computes this directly; {@link #encode} gives the same code for every float
 * from a table.
 */
final class Srgb {

    private static final CodeTable TABLE = CodeTable.of(SrgbCurve::fromLinear, 1);

    /** {@code THRESHOLD[c]} is the smallest float whose code is c; the last entry is never reached. */
    static final float[] THRESHOLD = TABLE.threshold();

    private static final float[] LINEAR = linearTable();

    private Srgb() {}

    /** Returns the code, 0 to 255, of a linear value by the formula; below 0 and NaN count as 0, above 1 as 1. */
    static int formula(float linear) {
        return CodeTable.formula(v -> SrgbCurve.fromLinear(Math.min(v, 1)), linear);
    }

    /** Returns the same code as {@link #formula} from the table. */
    static int encode(float linear) {
        return TABLE.encode(linear);
    }

    /** Returns the linear value, 0…1, of a code 0 to 255; {@code encode(linear(c)) == c}. */
    static float linear(int code) {
        return LINEAR[code];
    }

    private static float[] linearTable() {
        float[] linears = new float[256];
        for (int code = 0; code < 256; code++) {
            linears[code] = (float) SrgbCurve.toLinear(code / 255.0);
        }
        return linears;
    }
}
