package lightning.render.relight;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import lightning.base.work.Progress;

/** Fails at the n-th question whether to stop. */
final class FailAfter implements Progress {
    private final AtomicInteger left;
    private final Supplier<? extends Error> failure;

    /** @param questions how often the work may go on */
    FailAfter(int questions, Supplier<? extends Error> failure) {
        left = new AtomicInteger(questions);
        this.failure = failure;
    }

    @Override
    public void tiles(int done, int total) {}

    @Override
    public boolean isCancelled() {
        if (left.getAndUpdate(n -> Math.max(0, n - 1)) == 0) {
            throw failure.get();
        }
        return false;
    }
}
