package lightning.bench.accuracy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.locks.LockSupport;
import lightning.base.work.Progress;
import org.junit.jupiter.api.Test;

class TurnsTest {
    private final StringBuilder order = new StringBuilder();

    private Turns.Turn<RuntimeException> work(char name, double... times) {
        int[] next = {0};
        return () -> {
            order.append(name);
            return times[Math.min(next[0]++, times.length - 1)];
        };
    }

    @Test
    void works_takeTurns() {
        new Turns(3).take(List.of(work('a', 1), work('b', 1)), Progress.NONE);
        assertThat(order.toString()).matches("(ab)+").hasSizeGreaterThanOrEqualTo(10);
    }

    @Test
    void warmUp_lastsWhileAWorkBecomesFaster() {
        List<Timing> times = new Turns(2, 1e6).take(List.of(work('a', 64, 32, 16, 8, 4, 4, 4, 2, 1)), Progress.NONE);
        // 4 ms is the best of two rounds more: steady.
        assertThat(times.getFirst().milliseconds()).containsExactly(2.0, 1.0);
    }

    @Test
    void impatientWarmUp_isTwoRounds() {
        List<Timing> times = new Turns(2, 0).take(List.of(work('a', 64, 32, 16, 8)), Progress.NONE);
        assertThat(times.getFirst().milliseconds()).containsExactly(16.0, 8.0);
    }

    @Test
    void worksThatTakeNextToNothing_mustBeSteadyForAWhile() {
        // Java compiles late: the two are as slow for ten rounds and ten times as fast from then on.
        double[] late = {4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 0.4};
        List<Turns.Turn<RuntimeException>> works = List.of(work('a', late), work('b', late));
        var turns = new Turns(1, 1e6, 100);
        assertThat(turns.warmUp(works, Progress.NONE)).isTrue();
        assertThat(turns.measure(works, Progress.NONE).getFirst().milliseconds()).containsExactly(0.4);
    }

    @Test
    void impatientWarmUp_tellsThatItIsNotSteady() {
        assertThat(new Turns(1, 0).warmUp(List.of(work('a', 1)), Progress.NONE)).isFalse();
        assertThat(new Turns(1, 1e6).warmUp(List.of(work('a', 1)), Progress.NONE)).isTrue();
    }

    @Test
    void patience_isOfOwnWorkAndNotOfWhatOthersTakeOfTheMachine() {
        Turns.Turn<RuntimeException> work = work('a', 64, 32, 16, 8, 4, 2, 1);
        // Whoever waits for a processor works as little as whoever sleeps.
        Turns.Turn<RuntimeException> late = () -> {
            LockSupport.parkNanos(200_000_000);
            return work.milliseconds();
        };
        assertThat(new Turns(1, 1000).warmUp(List.of(late), Progress.NONE)).isTrue();
    }

    @Test
    void progress_hearsOfMeasuredRounds() {
        List<Integer> done = new ArrayList<>();
        new Turns(3, 0).take(List.of(work('a', 1)), new Progress() {
            @Override
            public void tiles(int tiles, int total) {
                done.add(tiles);
            }

            @Override
            public boolean isCancelled() {
                return false;
            }
        });
        assertThat(done).containsExactly(1, 2, 3);
    }

    @Test
    void cancelledMeasuring_stopsBeforeTheNextWork() {
        Progress stop = new Progress() {
            @Override
            public void tiles(int done, int total) {}

            @Override
            public boolean isCancelled() {
                return order.length() == 3;
            }
        };
        assertThatThrownBy(() -> new Turns(5, 0).take(List.of(work('a', 1), work('b', 1)), stop))
                .isInstanceOf(CancellationException.class);
        assertThat(order.toString()).isEqualTo("aba");
    }

    @Test
    void failingWork_failsTheMeasuring() {
        List<Turns.Turn<IOException>> works = List.of(() -> {
            throw new IOException("no disk");
        });
        assertThatThrownBy(() -> new Turns(1).take(works, Progress.NONE)).isInstanceOf(IOException.class).hasMessage("no disk");
    }

    @Test
    void time_isMeasuredAroundTheWork() {
        assertThat(Turns.time(() -> order.append('x'))).isNotNegative();
        assertThat(order.toString()).isEqualTo("x");
    }
}
