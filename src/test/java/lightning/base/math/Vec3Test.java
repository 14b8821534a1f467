package lightning.base.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class Vec3Test {

    @Test
    void products_matchManualResults() {
        Vec3 v = new Vec3(2, 3, 5);
        Vec3 w = new Vec3(7, 11, 13);
        assertThat(v.dot(w)).isEqualTo(14 + 33 + 65);
        assertThat(v.cross(w)).isEqualTo(new Vec3(3 * 13 - 5 * 11, 5 * 7 - 2 * 13, 2 * 11 - 3 * 7));
        assertThat(v.times(-2)).isEqualTo(new Vec3(-4, -6, -10));
    }

    @Test
    void lengths_matchManualResults() {
        assertThat(new Vec3(2, -3, 6).length()).isEqualTo(7);
        assertThat(new Vec3(2, -6, 3).maxAbs()).isEqualTo(6);
    }

    /** The squares of such components overflow or underflow. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1e-12, 1e12, 1e-200, 1e200, 1e-300, 1e300})
    void normalized_hasLengthOneAtEveryScale(double scale) {
        Vec3 v = new Vec3(2, -3, 6).times(scale).normalized();
        assertThat(v.x()).isCloseTo(2 / 7.0, within(1e-15));
        assertThat(v.y()).isCloseTo(-3 / 7.0, within(1e-15));
        assertThat(v.z()).isCloseTo(6 / 7.0, within(1e-15));
    }

    @Test
    void zeroAndNaN_haveNoDirection() {
        double inf = Double.POSITIVE_INFINITY;
        for (Vec3 v : new Vec3[] {Vec3.ZERO, new Vec3(Double.NaN, 1, 1), new Vec3(1, inf, 1), new Vec3(1, 1, -inf)}) {
            assertThatThrownBy(v::normalized).as("%s", v).isInstanceOf(ArithmeticException.class).hasMessageContaining("cannot normalize");
        }
    }
}
