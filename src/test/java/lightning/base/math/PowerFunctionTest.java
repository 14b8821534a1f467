package lightning.base.math;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.Scale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PowerFunctionTest {
    private static final int VALUES = 3_000_000;

    /** Uses bases distributed like cosines, and close to 0 and 1; exponents of every size that a scene may have. */
    @Test
    void randomValues_roundedToFloat_matchLibrary() {
        Random random = new Random(19);
        for (int i = 0; i < VALUES; i++) {
            double x = switch (i % 4) {
                case 0 -> 1 - Math.scalb(random.nextDouble(), -random.nextInt(50));
                case 1 -> Math.scalb(random.nextDouble(), -random.nextInt(60));
                default -> random.nextDouble();
            };
            double n = switch (i % 3) {
                case 0 -> random.nextInt(200);
                case 1 -> 100 * random.nextDouble();
                default -> Math.pow(10, 12 * random.nextDouble() - 6);
            };
            if (Float.floatToRawIntBits((float) PowerFunction.pow(x, n)) != Float.floatToRawIntBits((float) StrictMath.pow(x, n))) {
                assertThat((float) PowerFunction.pow(x, n)).as(x + " to the power of " + n).isEqualTo((float) StrictMath.pow(x, n));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-6, 0.5, 1, 2, 3.7, 1e4, 1e6})
    void rangeLimits_matchLibrary(double n) {
        for (double x : new double[] {0, Double.MIN_NORMAL, 1e-300, 1e-38, 0.5, Math.sqrt(0.5), Math.nextDown(Math.sqrt(0.5)),
            Math.nextUp(Math.sqrt(0.5)), Math.nextDown(1), 1}) {
            assertThat((float) PowerFunction.pow(x, n)).as(x + " to the power of " + n).isEqualTo((float) StrictMath.pow(x, n));
        }
    }

    @Test
    void zeroToPowerZero_isOne() {
        assertThat(PowerFunction.pow(0, 0)).isEqualTo(1);
        assertThat(PowerFunction.pow(Double.MIN_VALUE, 0)).isEqualTo(1);
    }

    @Test
    void zeroToPositivePower_isZero() {
        assertThat(PowerFunction.pow(0, 1e-300)).isZero();
        assertThat(PowerFunction.pow(0, 1e6)).isZero();
        assertThat(PowerFunction.pow(Double.MIN_NORMAL / 2, 1e-3)).as("counts as 0").isZero();
    }

    @Property(tries = 2000)
    void powerOfCosine_isInUnitRange(@ForAll @Scale(9) @DoubleRange(min = 0, max = 1) double x,
            @ForAll @DoubleRange(min = 0, max = 1e6) double n) {
        assertThat((float) PowerFunction.pow(x, n)).isBetween(0f, 1f);
    }

    /** The error is far below a float's: 2⁻⁴⁰ of the value if it is normal in float. */
    @Property(tries = 2000)
    void relativeError_isBelowFloatPrecision(@ForAll @Scale(9) @DoubleRange(min = 1e-3, max = 1) double x,
            @ForAll @DoubleRange(min = 0, max = 12) double n) {
        double expected = StrictMath.pow(x, n);
        assertThat(Math.abs(PowerFunction.pow(x, n) - expected)).isLessThanOrEqualTo(0x1p-40 * expected);
    }
}
