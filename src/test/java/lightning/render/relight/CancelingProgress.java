package lightning.render.relight;

import java.util.concurrent.atomic.AtomicInteger;
import lightning.base.work.Progress;

/** Asks to stop from the n-th question on; until then hears everything. */
final class CancelingProgress implements Progress {
    private final AtomicInteger remainingChecks;

    /** @param checks how often the work may go on */
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
