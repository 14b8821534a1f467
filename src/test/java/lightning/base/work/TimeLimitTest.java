package lightning.base.work;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.time.Duration;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.junit.jupiter.api.Test;

/** Limit of time for code that may not end. */
class TimeLimitTest {
    private static final Duration LONG = Duration.ofSeconds(Await.TIMEOUT_SECONDS);

    @Test
    void result_isReturned() throws Exception {
        assertThat(new TimeLimit(LONG).call("test", Duration.ZERO, () -> 7)).isEqualTo(7);
    }

    @Test
    void failure_isThrownAsTheCause() {
        assertThatExceptionOfType(ExecutionException.class).isThrownBy(() -> new TimeLimit(LONG).call("test", Duration.ZERO, () -> {
            throw new IllegalStateException("no");
        })).havingCause().isInstanceOf(IllegalStateException.class);
    }

    @Test
    void taskWithoutEnd_isInterruptedAndUsesUpTheLimit() throws Exception {
        var interrupted = new CountDownLatch(1);
        var limit = new TimeLimit(Duration.ofMillis(1));
        assertThatExceptionOfType(TimeoutException.class).isThrownBy(() -> limit.call("test", Duration.ZERO, () -> {
            try {
                new CountDownLatch(1).await();
                return 0;
            } finally {
                interrupted.countDown();
            }
        }));
        assertThat(interrupted.await(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS)).isTrue();
        assertThatExceptionOfType(TimeoutException.class).isThrownBy(() -> limit.call("test", LONG, () -> 7));
    }

    @Test
    void interruption_cancels() {
        var end = new CountDownLatch(1);
        Thread.currentThread().interrupt();
        assertThatExceptionOfType(CancellationException.class).isThrownBy(() -> new TimeLimit(LONG).call("test", Duration.ZERO, () -> {
            end.await();
            return 0;
        }));
        assertThat(Thread.interrupted()).isTrue();
        end.countDown();
    }
}
