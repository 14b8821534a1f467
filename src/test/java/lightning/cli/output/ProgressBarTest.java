package lightning.cli.output;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

class ProgressBarTest {
    private final ByteArrayOutputStream screen = new ByteArrayOutputStream();
    private final AtomicLong clock = new AtomicLong(-5_000_000_000L);

    private ProgressBar bar(boolean terminal) {
        var print = new PrintStream(screen, true, StandardCharsets.UTF_8);
        return new ProgressBar(new Console(print, print, terminal), "tracing", clock::get);
    }

    private void pass(double seconds) {
        clock.addAndGet((long) (seconds * 1e9));
    }

    @Test
    void firstSecond_showsNothing() {
        try (ProgressBar bar = bar(true)) {
            pass(0.9);
            bar.report(5, 10);
        }
        assertThat(screen.toString(StandardCharsets.UTF_8)).isEmpty();
    }

    @Test
    void afterOneSecond_showsPercentAndRemainingTime() {
        ProgressBar bar = bar(true);
        pass(2);
        bar.report(25, 100);
        assertThat(screen.toString(StandardCharsets.UTF_8)).endsWith("tracing [#######-----------------------]  25 %, 6 s left");
    }

    @Test
    void quickSteps_updateAtMostTenTimesPerSecond() {
        ProgressBar bar = bar(true);
        pass(2);
        bar.report(1, 10);
        int once = screen.size();
        pass(0.05);
        bar.report(2, 10);
        assertThat(screen.size()).isEqualTo(once);
        pass(0.05);
        bar.report(3, 10);
        assertThat(screen.size()).isGreaterThan(once);
    }

    @Test
    void noTerminal_showsNothing() {
        try (ProgressBar bar = bar(false)) {
            pass(20);
            bar.report(5, 10);
        }
        assertThat(screen.toString(StandardCharsets.UTF_8)).isEmpty();
    }

    @Test
    void printedLine_replacesTheBar() {
        var print = new PrintStream(screen, true, StandardCharsets.UTF_8);
        var console = new Console(print, print, true);
        try (var bar = new ProgressBar(console, "tracing", clock::get)) {
            pass(2);
            bar.report(5, 10);
            console.print("done");
        }
        assertThat(screen.toString(StandardCharsets.UTF_8)).endsWith("left\r\u001b[Kdone" + System.lineSeparator());
    }

    @Test
    void close_erasesTheLine() {
        try (ProgressBar bar = bar(true)) {
            pass(2);
            bar.report(5, 10);
        }
        assertThat(screen.toString(StandardCharsets.UTF_8)).endsWith("left\r\u001b[K");
    }

    @Test
    void duration_usesSecondsThenMinutes() {
        assertThat(ProgressBar.duration(0.2)).isEqualTo("1 s");
        assertThat(ProgressBar.duration(59.5)).isEqualTo("1:00 min");
        assertThat(ProgressBar.duration(125)).isEqualTo("2:05 min");
    }
}
