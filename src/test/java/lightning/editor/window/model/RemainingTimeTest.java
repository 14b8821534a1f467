package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class RemainingTimeTest {
    private static final long SECOND = 1_000_000_000;

    private final RemainingTime remainingTime = new RemainingTime();

    private String describe(String what, double share, double at) {
        return remainingTime.describe(what, share, 5 * SECOND + (long) (at * SECOND));
    }

    @Test
    void afterOneSecond_timeIsExtrapolated() {
        describe("Tracing", 0, 0);
        assertThat(describe("Tracing", 0.1, 0.5)).isEqualTo("Tracing");
        assertThat(describe("Tracing", 0.25, 2)).isEqualTo("Tracing · 6 s left");
        assertThat(describe("Tracing", 0.1, 4)).isEqualTo("Tracing · 40 s left");
        assertThat(describe("Tracing", 0.1, 20)).isEqualTo("Tracing · 3 min left");
    }

    @Test
    void smallShare_hasNoEstimate() {
        describe("Tracing", 0, 0);
        assertThat(describe("Tracing", 0.01, 30)).isEqualTo("Tracing");
        assertThat(describe("Tracing", Double.NaN, 30)).isEqualTo("Tracing");
        assertThat(describe("Tracing", -1, 30)).isEqualTo("Tracing");
    }

    @Test
    void timeBeforeFirstProgress_isNotExtrapolated() {
        describe("Tracing", 0, 0);
        describe("Tracing", 0, 10);
        assertThat(describe("Tracing", 0.25, 12)).isEqualTo("Tracing · 6 s left");
    }

    /** One tenth takes 10 s in a cold program, and each further tenth 1 s. */
    @Test
    void slowStart_doesNotCountTwice() {
        describe("Tracing", 0, 0);
        assertThat(describe("Tracing", 0.05, 5)).isEqualTo("Tracing");
        describe("Tracing", 0.1, 10);
        describe("Tracing", 0.15, 10.5);
        assertThat(describe("Tracing", 0.2, 11)).isEqualTo("Tracing · 8 s left");
        assertThat(describe("Tracing", 0.3, 12)).isEqualTo("Tracing · 7 s left");
    }

    @Test
    void longTask_isExtrapolatedEarly() {
        describe("Tracing", 0, 0);
        assertThat(describe("Tracing", 0.05, 30)).isEqualTo("Tracing · 10 min left");
    }

    @Test
    void otherTask_restartsEstimate() {
        describe("Tracing", 0, 0);
        assertThat(describe("Verifying", 0.5, 10)).isEqualTo("Verifying");
        assertThat(describe("Verifying", 0.5, 14)).isEqualTo("Verifying · 4 s left");
    }
}
