package lightning.editor.window.mixer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

class FaderScaleTest {
    private static final FaderScale SCALE = new FaderScale(10);

    @Test
    void endsAndMiddle_areExact() {
        assertThat(SCALE.stops(-1)).isEqualTo(-10);
        assertThat(SCALE.stops(0)).isZero();
        assertThat(SCALE.stops(1)).isEqualTo(10);
        assertThat(SCALE.position(-10)).isCloseTo(-1, within(1e-15));
        assertThat(SCALE.position(Double.NEGATIVE_INFINITY)).isCloseTo(-1, within(1e-15));
        assertThat(SCALE.position(0)).isZero();
        assertThat(SCALE.position(25)).isCloseTo(1, within(1e-15));
    }

    @Property
    void position_isTheInverse(@ForAll @DoubleRange(min = -10, max = 10) double stops) {
        assertThat(SCALE.stops(SCALE.position(stops))).isCloseTo(stops, within(1e-12));
    }

    @Test
    void middle_hasMostOfTheTravel() {
        assertThat(SCALE.position(3) - SCALE.position(-3)).as("of a travel of 2").isGreaterThan(1.1);
    }

    @Test
    void lowFader_isAsFineAsAHighOne() {
        double moved = SCALE.stops(FaderScale.drag(20, 35));
        assertThat(moved).as("20 pixels of a fader of 35").isBetween(0.3, 1.0);
        assertThat(FaderScale.drag(500, 500)).as("whole length of a high fader").isEqualTo(2);
    }
}
