package lightning.base.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

class TransformTest {
    private static final Transform A = new Transform(2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37);
    private static final Transform B = new Transform(41, 43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89);

    /** Whole numbers avoid rounding. */
    @Test
    void transformPoint_appliesMatrixAndTranslation() {
        assertThat(A.transformPoint(new Vec3(1, 10, 100)))
                .isEqualTo(new Vec3(2 + 30 + 500 + 7, 11 + 130 + 1700 + 19, 23 + 290 + 3100 + 37));
        assertThat(A.transformVector(new Vec3(1, 10, 100))).isEqualTo(new Vec3(2 + 30 + 500, 11 + 130 + 1700, 23 + 290 + 3100));
    }

    @Test
    void product_composesMaps() {
        Transform product = A.times(B);
        for (Vec3 p : new Vec3[] {Vec3.ZERO, new Vec3(1, 0, 0), Vec3.Y, new Vec3(0, 0, 1), new Vec3(3, -2, 6)}) {
            assertThat(product.transformPoint(p)).isEqualTo(A.transformPoint(B.transformPoint(p)));
            assertThat(product.transformVector(p)).isEqualTo(A.transformVector(B.transformVector(p)));
        }
        assertThat(A.times(Transform.IDENTITY)).isEqualTo(A);
        assertThat(Transform.IDENTITY.times(A)).isEqualTo(A);
    }

    @Test
    void translationAndScaling_transformPoints() {
        assertThat(Transform.translation(new Vec3(1, 2, 3)).transformPoint(new Vec3(10, 20, 30))).isEqualTo(new Vec3(11, 22, 33));
        assertThat(Transform.scaling(new Vec3(1, 2, 3)).transformPoint(new Vec3(10, 20, 30))).isEqualTo(new Vec3(10, 40, 90));
    }

    @Test
    void transposed_swapsRowsAndColumnsWithoutTranslation() {
        assertThat(A.transposed()).isEqualTo(new Transform(2, 11, 23, 0, 3, 13, 29, 0, 5, 17, 31, 0));
    }

    /** About x, y maps to z; about y, z to x; about z, x to y; zeros and ones are exact. */
    @Test
    void quarterTurns_areExactAndCounterClockwise() {
        Vec3 x = new Vec3(1, 0, 0);
        Vec3 z = new Vec3(0, 0, 1);
        assertThat(Transform.rotation(new Vec3(90, 0, 0)).transformVector(Vec3.Y)).isEqualTo(z);
        assertThat(Transform.rotation(new Vec3(0, 90, 0)).transformVector(z)).isEqualTo(x);
        assertThat(Transform.rotation(new Vec3(0, 0, 90)).transformVector(x)).isEqualTo(Vec3.Y);
        assertThat(Transform.rotation(new Vec3(90, 90, 0)).transformVector(Vec3.Y)).as("about x first").isEqualTo(x);
        assertThat(Transform.rotation(new Vec3(0, 90, 90)).transformVector(z)).as("about y before z").isEqualTo(Vec3.Y);
    }

    @Test
    void sineAndCosine_areExactAtQuarterTurns() {
        for (int turn = -8; turn <= 8; turn++) {
            double[] cosines = {1, 0, -1, 0};
            assertThat(Transform.cosDegrees(90 * turn)).as(90 * turn + "°").isEqualTo(cosines[Math.floorMod(turn, 4)]);
            assertThat(Transform.sinDegrees(90 * turn)).as(90 * turn + "°").isEqualTo(cosines[Math.floorMod(turn - 1, 4)]);
        }
    }

    @Property
    void sineAndCosine_matchTheAngle(@ForAll @DoubleRange(min = -1e4, max = 1e4) double degrees) {
        double angle = StrictMath.toRadians(degrees % 360);
        assertThat(Transform.cosDegrees(degrees)).isCloseTo(StrictMath.cos(angle), within(1e-14));
        assertThat(Transform.sinDegrees(degrees)).isCloseTo(StrictMath.sin(angle), within(1e-12));
    }
}
