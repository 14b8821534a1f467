package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class RemainingTest {
    private static final long SECOND = 1_000_000_000;

    private final Remaining remaining = new Remaining();

    private String tell(String what, double share, double at) {
        return remaining.tell(what, share, 5 * SECOND + (long) (at * SECOND));
    }

    @Test
    void afterASecond_whatIsLeftFollowsFromWhatIsDone() {
        tell("Tracing", 0, 0);
        assertThat(tell("Tracing", 0.1, 0.5)).isEqualTo("Tracing");
        assertThat(tell("Tracing", 0.25, 2)).isEqualTo("Tracing · 6 s left");
        assertThat(tell("Tracing", 0.1, 4)).isEqualTo("Tracing · 40 s left");
        assertThat(tell("Tracing", 0.1, 20)).isEqualTo("Tracing · 3 min left");
    }

    @Test
    void whereAlmostNothingIsDone_nothingIsGuessed() {
        tell("Tracing", 0, 0);
        assertThat(tell("Tracing", 0.01, 30)).isEqualTo("Tracing");
        assertThat(tell("Tracing", Double.NaN, 30)).isEqualTo("Tracing");
        assertThat(tell("Tracing", -1, 30)).isEqualTo("Tracing");
    }

    @Test
    void anotherWork_beginsAnew() {
        tell("Tracing", 0, 0);
        assertThat(tell("Verifying", 0.5, 10)).isEqualTo("Verifying");
        assertThat(tell("Verifying", 0.5, 14)).isEqualTo("Verifying · 4 s left");
    }
}
