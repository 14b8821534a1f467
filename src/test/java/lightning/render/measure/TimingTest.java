package lightning.render.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.NotEmpty;
import org.junit.jupiter.api.Test;

class TimingTest {
    @Test
    void quartilesOfFiveSamples_areSamples() {
        Timing timing = new Timing(List.of(50.0, 10.0, 30.0, 20.0, 40.0));
        assertThat(timing.lowerQuartile()).isEqualTo(20);
        assertThat(timing.median()).isEqualTo(30);
        assertThat(timing.upperQuartile()).isEqualTo(40);
        assertThat(timing.milliseconds()).containsExactly(50.0, 10.0, 30.0, 20.0, 40.0);
    }

    @Test
    void quartilesBetweenSamples_areInterpolated() {
        Timing timing = new Timing(List.of(1.0, 2.0, 3.0, 4.0));
        assertThat(timing.lowerQuartile()).isEqualTo(1.75);
        assertThat(timing.median()).isEqualTo(2.5);
        assertThat(timing.upperQuartile()).isEqualTo(3.25);
    }

    @Test
    void saving_isNegativeIfSlower() {
        assertThat(new Timing(List.of(5.0)).percentSavedOf(20)).isEqualTo(75);
        assertThat(new Timing(List.of(30.0)).percentSavedOf(20)).isEqualTo(-50);
    }

    @Property
    void quartiles_areInOrderAndWithinTheSamples(@ForAll @NotEmpty List<@DoubleRange(max = 1e9) Double> samples) {
        Timing timing = new Timing(samples);
        assertThat(timing.lowerQuartile()).isBetween(samples.stream().min(Double::compare).orElseThrow(), timing.median());
        assertThat(timing.upperQuartile()).isBetween(timing.median(), samples.stream().max(Double::compare).orElseThrow());
    }

    @Test
    void invalidSamples_areRejected() {
        assertThatThrownBy(() -> new Timing(List.of())).isInstanceOf(IllegalArgumentException.class).hasMessageContaining("at least one");
        for (double bad : new double[] {-1, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThatThrownBy(() -> new Timing(List.of(1.0, bad))).isInstanceOf(IllegalArgumentException.class)
                    .hasMessage("timing: expected milliseconds ≥ 0, found " + bad);
        }
    }
}
