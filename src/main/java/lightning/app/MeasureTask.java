package lightning.app;

import java.util.function.Function;
import javafx.concurrent.Task;
import lightning.shading.Progress;

/** Measures something on a thread of its own; cancelled, it stops soon. */
final class MeasureTask<T> extends Task<T> {
    private final Function<Progress, T> work;

    MeasureTask(Function<Progress, T> work) {
        this.work = work;
    }

    @Override
    protected T call() {
        return work.apply(new Progress() {
            @Override
            public void tiles(int done, int total) {
                updateProgress(done, total);
            }

            @Override
            public boolean isCancelled() {
                return MeasureTask.this.isCancelled();
            }
        });
    }

    void begin() {
        Thread thread = new Thread(this, "lightning-measure");
        thread.setDaemon(true);
        thread.start();
    }
}
