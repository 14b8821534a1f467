package lightning.render.relight;

import java.util.concurrent.atomic.AtomicInteger;
import lightning.base.work.Progress;

/** Progress that requests cancellation at the n-th check; until then it accepts all reports. */
final class CancelingProgress implements Progress {
    private final AtomicInteger remainingChecks;

    /** @param checks number of checks before cancellation */
    CancelingProgress(int checks) {
        remainingChecks = new AtomicInteger(checks);
    }

    @Override
    public void report(int done, int total) {}

    @Override
    public boolean isCanceled() {
        return remainingChecks.getAndUpdate(n -> Math.max(0, n - 1)) == 0;
    }
}
