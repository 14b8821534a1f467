package lightning.base.work;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

class WorkerPoolTest {
    private static final int TILES = 1000;
    /** More tiles than are processed before any other thread starts. */
    private static final int ENDLESS = Integer.MAX_VALUE;

    /** An interrupted caller that waits appears interrupted only to itself. */
    @Test
    void cancellation_seenByOneWorker_stopsAll() {
        Thread caller = Thread.currentThread();
        CountDownLatch heard = new CountDownLatch(1);
        AtomicInteger done = new AtomicInteger();
        Progress callers = new Progress() {
            @Override
            public void report(int tiles, int total) {}

            @Override
            public boolean isCanceled() {
                if (Thread.currentThread() == caller) {
                    heard.countDown();
                    return true;
                }
                return false;
            }
        };
        try (WorkerPool workers = new WorkerPool(2)) {
            assertThatThrownBy(() -> workers.run(ENDLESS, (_, _) -> {
                await(heard);
                done.incrementAndGet();
            }, callers)).isInstanceOf(CancellationException.class);
        }
        assertThat(done.get()).isLessThan(ENDLESS);
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    @Test
    void everyTile_runsOnce() {
        AtomicInteger[] runs = new AtomicInteger[TILES];
        Arrays.setAll(runs, _ -> new AtomicInteger());
        try (WorkerPool workers = new WorkerPool(3)) {
            workers.run(TILES, (_, tile) -> runs[tile].incrementAndGet(), Progress.NONE);
        }
        assertThat(runs).allMatch(count -> count.get() == 1);
    }

    /** Simulates a busy machine, on which a small update would wait for a thread without work. */
    @Test
    @Timeout(value = Await.TIMEOUT_SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void lateThread_isNotAwaited() throws Exception {
        CountDownLatch busy = new CountDownLatch(1);
        CountDownLatch free = new CountDownLatch(1);
        try (WorkerPool workers = new WorkerPool(2)) {
            Thread other = Thread.ofPlatform().start(() -> workers.run(2, (worker, _) -> {
                if (worker == 1) {
                    busy.countDown();
                }
                await(worker == 1 ? free : busy);
            }, Progress.NONE));
            await(busy);
            AtomicInteger done = new AtomicInteger();
            while (other.getState() != Thread.State.WAITING) {
                Thread.onSpinWait();
            }
            workers.run(3, (_, _) -> done.incrementAndGet(), Progress.NONE);
            assertThat(done.get()).isEqualTo(3);
            free.countDown();
            other.join();
        }
    }

    @Test
    void interruptedCaller_awaitsWorkersAndStaysInterrupted() {
        AtomicInteger working = new AtomicInteger();
        CountDownLatch begun = new CountDownLatch(1);
        try (WorkerPool workers = new WorkerPool(2)) {
            workers.run(2, (worker, _) -> {
                working.incrementAndGet();
                if (worker == 0) {
                    await(begun);
                    Thread.currentThread().interrupt();
                } else {
                    begun.countDown();
                    LockSupport.parkNanos(20_000_000);
                }
                working.decrementAndGet();
            }, Progress.NONE);
            assertThat(working.get()).isZero();
            assertThat(Thread.interrupted()).isTrue();
        }
    }
}
