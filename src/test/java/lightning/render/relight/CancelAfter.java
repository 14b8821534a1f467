package lightning.render.relight;

import java.util.concurrent.atomic.AtomicInteger;
import lightning.base.work.Progress;

/** Asks to stop from the n-th question on; until then hears everything. */
final class CancelAfter implements Progress {
    private final AtomicInteger left;

    /** @param questions how often the work may go on */
    CancelAfter(int questions) {
        left = new AtomicInteger(questions);
    }

    @Override
    public void tiles(int done, int total) {}

    @Override
    public boolean isCancelled() {
        return left.getAndUpdate(n -> Math.max(0, n - 1)) == 0;
    }
}
