package lightning.base.work;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.time.Duration;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeoutException;
import org.junit.jupiter.api.Test;

/** Limit of time for code that may not end. */
class TimeLimitTest {
    private static final Duration LONG = Duration.ofSeconds(Await.TIMEOUT_SECONDS);

    @Test
    void result_isReturned() throws Exception {
        assertThat(TimeLimit.call("test", LONG, () -> 7)).isEqualTo(7);
    }

    @Test
    void failure_isThrownAsTheCause() {
        assertThatExceptionOfType(ExecutionException.class).isThrownBy(() -> TimeLimit.call("test", LONG, () -> {
            throw new IllegalStateException("no");
        })).havingCause().isInstanceOf(IllegalStateException.class);
    }

    @Test
    void taskWithoutEnd_isLeft() {
        var end = new CountDownLatch(1);
        assertThatExceptionOfType(TimeoutException.class).isThrownBy(() -> TimeLimit.call("test", Duration.ofMillis(1), () -> {
            end.await();
            return 0;
        }));
        end.countDown();
    }

    @Test
    void interruption_cancels() {
        var end = new CountDownLatch(1);
        Thread.currentThread().interrupt();
        assertThatExceptionOfType(CancellationException.class).isThrownBy(() -> TimeLimit.call("test", LONG, () -> {
            end.await();
            return 0;
        }));
        assertThat(Thread.interrupted()).isTrue();
        end.countDown();
    }
}
