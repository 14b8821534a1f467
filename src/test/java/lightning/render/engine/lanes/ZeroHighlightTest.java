package lightning.render.engine.lanes;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.math.PowerFunction;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

/** Tests the highlights for which no power is computed. */
class ZeroHighlightTest {
    /** Draws the exponent, so that every magnitude of shininess occurs. */
    @Property
    void zeroPowerCosine_hasZeroPowerAsFloat(@ForAll @DoubleRange(min = -6, max = 6) double exponent,
            @ForAll @DoubleRange(min = 0, max = 1) double share) {
        double shininess = Math.min(StrictMath.pow(10, exponent), 1e6);
        double faint = LightLanes.zeroPowerCosine(shininess);
        assertThat((float) PowerFunction.pow(faint, shininess)).isZero();
        assertThat((float) PowerFunction.pow(share * faint, shininess)).isZero();
    }

    @Property
    void cosineSlightlyAboveThreshold_hasNonzeroPower(@ForAll @DoubleRange(min = 0, max = 6) double exponent) {
        double shininess = Math.min(StrictMath.pow(10, exponent), 1e6);
        double above = LightLanes.zeroPowerCosine(shininess) * StrictMath.pow(2, 4 / shininess);
        assertThat((float) PowerFunction.pow(above, shininess)).isPositive();
    }

    @Test
    void shininessZero_hasNoZeroPowerCosine() {
        assertThat(LightLanes.zeroPowerCosine(0)).isNegative();
    }
}
