package lightning.render.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.locks.LockSupport;
import lightning.base.work.Progress;
import org.junit.jupiter.api.Test;

class InterleavedTimerTest {
    private final StringBuilder order = new StringBuilder();

    private InterleavedTimer.TimedTask<RuntimeException> task(char name, double... times) {
        int[] next = {0};
        return () -> {
            order.append(name);
            return times[Math.min(next[0]++, times.length - 1)];
        };
    }

    @Test
    void tasks_areInterleaved() {
        new InterleavedTimer(3).warmUpAndMeasure(List.of(task('a', 1), task('b', 1)), Progress.NONE);
        assertThat(order.toString()).matches("(ab)+").hasSizeGreaterThanOrEqualTo(10);
    }

    @Test
    void warmUp_continuesWhileATaskGetsFaster() {
        List<Timing> times = new InterleavedTimer(2, 1e6).warmUpAndMeasure(List.of(task('a', 64, 32, 16, 8, 4, 4, 4, 2, 1)), Progress.NONE);
        // 4 ms is still the best after two more rounds: steady.
        assertThat(times.getFirst().milliseconds()).containsExactly(2.0, 1.0);
    }

    @Test
    void warmUpWithoutTime_hasTwoRounds() {
        List<Timing> times = new InterleavedTimer(2, 0).warmUpAndMeasure(List.of(task('a', 64, 32, 16, 8)), Progress.NONE);
        assertThat(times.getFirst().milliseconds()).containsExactly(16.0, 8.0);
    }

    @Test
    void veryShortTasks_mustBeSteadyForMinimumTime() {
        // Late compilation: both are equally slow for ten rounds, then ten times as fast.
        double[] late = {4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 0.4};
        List<InterleavedTimer.TimedTask<RuntimeException>> works = List.of(task('a', late), task('b', late));
        var turns = new InterleavedTimer(1, 1e6, 100);
        assertThat(turns.warmUp(works, Progress.NONE)).isTrue();
        assertThat(turns.measure(works, Progress.NONE).getFirst().milliseconds()).containsExactly(0.4);
    }

    @Test
    void warmUpWithoutTime_reportsNotSteady() {
        assertThat(new InterleavedTimer(1, 0).warmUp(List.of(task('a', 1)), Progress.NONE)).isFalse();
        assertThat(new InterleavedTimer(1, 1e6).warmUp(List.of(task('a', 1)), Progress.NONE)).isTrue();
    }

    @Test
    void warmUpLimit_countsOnlyOwnCpuTime() {
        InterleavedTimer.TimedTask<RuntimeException> work = task('a', 64, 32, 16, 8, 4, 2, 1);
        // Waiting for a processor uses as little processor time as sleeping.
        InterleavedTimer.TimedTask<RuntimeException> late = () -> {
            LockSupport.parkNanos(200_000_000);
            return work.runMs();
        };
        assertThat(new InterleavedTimer(1, 1000).warmUp(List.of(late), Progress.NONE)).isTrue();
    }

    @Test
    void progress_reportsMeasuredRounds() {
        List<Integer> done = new ArrayList<>();
        new InterleavedTimer(3, 0).warmUpAndMeasure(List.of(task('a', 1)), new Progress() {
            @Override
            public void report(int tiles, int total) {
                done.add(tiles);
            }

            @Override
            public boolean isCanceled() {
                return false;
            }
        });
        assertThat(done).containsExactly(1, 2, 3);
    }

    @Test
    void canceledMeasurement_stopsBeforeNextTask() {
        Progress stop = new Progress() {
            @Override
            public void report(int done, int total) {}

            @Override
            public boolean isCanceled() {
                return order.length() == 3;
            }
        };
        assertThatThrownBy(() -> new InterleavedTimer(5, 0).warmUpAndMeasure(List.of(task('a', 1), task('b', 1)), stop))
                .isInstanceOf(CancellationException.class);
        assertThat(order.toString()).isEqualTo("aba");
    }

    @Test
    void failingTask_failsMeasurement() {
        List<InterleavedTimer.TimedTask<IOException>> works = List.of(() -> {
            throw new IOException("no disk");
        });
        assertThatThrownBy(() -> new InterleavedTimer(1).warmUpAndMeasure(works, Progress.NONE)).isInstanceOf(IOException.class)
                .hasMessage("no disk");
    }

    @Test
    void timeMs_measuresTheTask() {
        assertThat(InterleavedTimer.timeMs(() -> order.append('x'))).isNotNegative();
        assertThat(order.toString()).isEqualTo("x");
    }
}
