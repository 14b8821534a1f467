package lightning.render.fog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import lightning.base.math.Vec3;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;

class FogMediumTest {
    private static final FogMedium EVEN = new FogMedium(0.2, 0, 0, null, null);
    private static final FogMedium BOX = new FogMedium(0.2, 0, 0, new Vec3(-1, -1, -1), new Vec3(1, 1, 1));

    @Example
    void evenFog_hasDepthOfDensityTimesLength() {
        assertThat(EVEN.depth(0, 0, 0, 1, 0, 0, 5)).isEqualTo(1);
        assertThat(EVEN.depth(0, 0, 0, 1, 0, 0, Double.POSITIVE_INFINITY)).isInfinite();
        assertThat(FogMedium.transmittance(1)).isCloseTo(1 / Math.E, within(1e-15));
        assertThat(FogMedium.transmittance(Double.POSITIVE_INFINITY)).isZero();
    }

    @Example
    void rayBesideBox_hasNoDepth() {
        assertThat(BOX.depth(-5, 2, 0, 1, 0, 0, 100)).isZero();
        assertThat(BOX.depth(-5, 0, 0, -1, 0, 0, 100)).isZero();
        assertThat(BOX.depth(-5, 0, 0, 1, 0, 0, 3)).as("ends before the box").isZero();
    }

    @Example
    void rayThroughBox_countsOnlyInside() {
        assertThat(BOX.depth(-5, 0, 0, 1, 0, 0, Double.POSITIVE_INFINITY)).isCloseTo(0.4, within(1e-15));
        assertThat(BOX.depth(0, 0, 0, 0, 0, 1, Double.POSITIVE_INFINITY)).as("from inside").isCloseTo(0.2, within(1e-15));
        assertThat(BOX.depth(-5, 0, 0, 1, 0, 0, 4.5)).as("ends inside").isCloseTo(0.1, within(1e-15));
    }

    @Example
    void fallingDensity_hasFiniteDepthUpward() {
        FogMedium low = new FogMedium(0.2, 1, 0.5, null, null);
        assertThat(low.depth(0, 1, 0, 0, 1, 0, Double.POSITIVE_INFINITY)).as("density / falloff").isCloseTo(0.4, within(1e-15));
        assertThat(low.depth(0, -1, 0, 0, 1, 0, Double.POSITIVE_INFINITY)).as("and two units below").isCloseTo(0.8, within(1e-15));
        assertThat(low.depth(0, 5, 0, 0, -1, 0, Double.POSITIVE_INFINITY)).isInfinite();
        assertThat(low.depth(0, 0.5, 0, 1, 0, 0, 3)).as("level, below the height").isCloseTo(0.6, within(1e-15));
    }

    /** Compares with the midpoint rule over 4000 parts. */
    @Property
    void fallingDensity_equalsItsIntegral(@ForAll @DoubleRange(min = -3, max = 3) double y,
            @ForAll @DoubleRange(min = -1, max = 1) double dy,
            @ForAll @DoubleRange(min = 0.01, max = 2) double decay, @ForAll @DoubleRange(min = 0, max = 10) double length) {
        FogMedium medium = new FogMedium(0.3, 0.5, decay, new Vec3(-4, -4, -4), new Vec3(4, 2, 4));
        double dx = Math.sqrt(1 - dy * dy);
        double sum = 0;
        int parts = 4000;
        for (int i = 0; i < parts; i++) {
            double t = (i + 0.5) / parts * length;
            double height = y + t * dy;
            boolean inside = t * dx <= 4 && height >= -4 && height <= 2;
            sum += inside ? 0.3 * Math.exp(-decay * Math.max(0, height - 0.5)) * length / parts : 0;
        }
        assertThat(medium.depth(0, y, 0, dx, dy, 0, length)).isCloseTo(sum, within(3e-3));
    }
}
