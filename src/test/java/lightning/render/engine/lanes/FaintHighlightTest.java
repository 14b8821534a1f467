package lightning.render.engine.lanes;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.math.Power;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

/** Highlights of which no power is computed. */
class FaintHighlightTest {
    /** The exponent is drawn, so that all sizes of shininess come up. */
    @Property
    void faintCosine_hasThePower0AsAFloat(@ForAll @DoubleRange(min = -6, max = 6) double exponent,
            @ForAll @DoubleRange(min = 0, max = 1) double share) {
        double shininess = Math.min(StrictMath.pow(10, exponent), 1e6);
        double faint = LightLanes.faint(shininess);
        assertThat((float) Power.of(faint, shininess)).isZero();
        assertThat((float) Power.of(share * faint, shininess)).isZero();
    }

    @Property
    void cosineALittleAboveFaint_hasAPower(@ForAll @DoubleRange(min = 0, max = 6) double exponent) {
        double shininess = Math.min(StrictMath.pow(10, exponent), 1e6);
        double above = LightLanes.faint(shininess) * StrictMath.pow(2, 4 / shininess);
        assertThat((float) Power.of(above, shininess)).isPositive();
    }

    @Test
    void noCosineIsFaint_whereThePowerIsAlways1() {
        assertThat(LightLanes.faint(0)).isNegative();
    }
}
