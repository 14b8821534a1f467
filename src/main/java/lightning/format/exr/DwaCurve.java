package lightning.format.exr;

import java.util.function.DoubleUnaryOperator;

/**
 * Curve of DWA's colors, by half bits: steps of the curve look equal. Up to 1 it is the 2.2th root, above it a logarithm with the same slope at
 * 1. Infinities and NaN become 0.
 */
final class DwaCurve {
    private static final double GAMMA = 2.2;
    /** Bits of a half's exponent: all are set for infinities and NaN. */
    private static final int EXPONENT = 0x7C00;

    private static final short[] TO_CURVE = table(DwaCurve::toCurve);
    private static final short[] FROM_CURVE = table(DwaCurve::fromCurve);

    private DwaCurve() {}

    private static short[] table(DoubleUnaryOperator function) {
        short[] table = new short[1 << Short.SIZE];
        for (int bits = 0; bits < table.length; bits++) {
            float value = Float.float16ToFloat((short) bits);
            table[bits] = (bits & EXPONENT) == EXPONENT || value == 0 ? 0
                    : Float.floatToFloat16((float) Math.copySign(function.applyAsDouble(Math.abs(value)), value));
        }
        return table;
    }

    private static double toCurve(double light) {
        return light <= 1 ? Math.pow(light, 1 / GAMMA) : Math.log(light) / GAMMA + 1;
    }

    private static double fromCurve(double value) {
        return value <= 1 ? Math.pow(value, GAMMA) : Math.exp(GAMMA * (value - 1));
    }

    /** Returns the half on the curve of a half that is proportional to light. */
    static short toCurve(short light) {
        return TO_CURVE[Short.toUnsignedInt(light)];
    }

    /** Returns the half, proportional to light, of one on the curve. */
    static short fromCurve(short value) {
        return FROM_CURVE[Short.toUnsignedInt(value)];
    }
}
