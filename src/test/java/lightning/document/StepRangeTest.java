package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

class StepRangeTest {
    private final StepRange tenths = new StepRange(0.1, 0, 10);

    @Test
    void steps_addInDecimal() {
        assertThat(tenths.addSteps(1.1, 1)).isEqualTo(1.2);
        assertThat(tenths.addSteps(0.3, -3)).isZero();
        assertThat(tenths.addSteps(0.7, 0.1)).isEqualTo(0.71);
    }

    @Property
    void steps_stayWithinTheLimitsAndElseGoTheWholeWay(@ForAll @DoubleRange(max = 10) double value,
            @ForAll @DoubleRange(min = -200, max = 200) double steps) {
        double wanted = Math.clamp(value + 0.1 * steps, 0, 10);
        assertThat(tenths.addSteps(value, steps)).isBetween(0.0, 10.0).isCloseTo(wanted, within(1e-9));
    }
}
