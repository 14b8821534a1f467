package lightning.render.relight;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import lightning.base.work.Progress;

/** Progress that fails at the n-th cancellation check. */
final class FailingProgress implements Progress {
    private final AtomicInteger remainingChecks;
    private final Supplier<? extends Error> failure;

    /** @param checks number of checks before the failure */
    FailingProgress(int checks, Supplier<? extends Error> failure) {
        remainingChecks = new AtomicInteger(checks);
        this.failure = failure;
    }

    @Override
    public void report(int done, int total) {}

    @Override
    public boolean isCanceled() {
        if (remainingChecks.getAndUpdate(n -> Math.max(0, n - 1)) == 0) {
            throw failure.get();
        }
        return false;
    }
}
