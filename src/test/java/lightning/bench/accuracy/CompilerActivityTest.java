package lightning.bench.accuracy;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class CompilerActivityTest {
    private final double[] compileMs = {1000};
    private final double[] now = {5000};
    private final CompilerActivity.CompilerWatch watch = new CompilerActivity(() -> compileMs[0], () -> now[0]).startWatch();

    private void advance(double ms, double compiling) {
        compileMs[0] += compiling;
        now[0] += ms;
    }

    @Test
    void compilers_areIdleBelowFivePercent() {
        advance(100, 4);
        assertThat(watch.isIdle()).isTrue();
        advance(0, 2);
        assertThat(watch.isIdle()).isFalse();
        advance(100, 0);
        assertThat(watch.isIdle()).isTrue();
    }
}
