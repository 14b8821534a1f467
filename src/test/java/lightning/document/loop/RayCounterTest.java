package lightning.document.loop;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class RayCounterTest {
    private long now;
    private final RayCounter counter = new RayCounter(() -> now);

    private void cast(long rays, double seconds) {
        now = (long) (seconds * 1e9);
        counter.add(rays);
    }

    @Test
    void firstReport_startsTheClockOfTheRate() {
        cast(5_000_000, 3);
        assertThat(counter.activity().raysPerSecond()).isZero();
        cast(1_000_000, 3.5);
        cast(2_000_000, 4);
        assertThat(counter.activity().raysPerSecond()).isEqualTo(3_000_000);
    }

    @Test
    void nextStage_startsAgain() {
        cast(1, 1);
        cast(1_000_000, 2);
        counter.start(RenderActivity.Stage.SAMPLES);
        assertThat(counter.activity().stage()).isEqualTo(RenderActivity.Stage.SAMPLES);
        assertThat(counter.activity().raysPerSecond()).isZero();
        now += 1_000_000;
        assertThat(counter.activity().nanoseconds()).isEqualTo(1_000_000);
    }
}
