package lightning.sample;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import lightning.base.work.Progress;

/** Progress that keeps each reported share, 0…1, and never cancels. Thread-safe. */
public final class ProgressRecorder implements Progress {
    private final List<Double> shares = new CopyOnWriteArrayList<>();

    /** Returns the shares in the order in which they were reported. */
    public List<Double> shares() {
        return shares;
    }

    @Override
    public void report(int done, int total) {
        shares.add((double) done / total);
    }

    @Override
    public boolean isCanceled() {
        return false;
    }
}
