package lightning.editor.window.measure;

import java.util.function.Function;
import javafx.concurrent.Task;
import lightning.base.work.DedicatedThread;
import lightning.base.work.Progress;

/** Background measurement on a dedicated thread. */
final class MeasureTask<T> extends Task<T> {
    private final String thread;
    private final Function<Progress, T> work;

    /**
     * @param thread  name of the thread
     * @param work  measurement; stops when its progress is canceled
     */
    MeasureTask(String thread, Function<Progress, T> work) {
        this.thread = thread;
        this.work = work;
    }

    @Override
    protected T call() {
        return work.apply(new Progress() {
            @Override
            public void report(int done, int total) {
                updateProgress(done, total);
            }

            @Override
            public boolean isCanceled() {
                return MeasureTask.this.isCancelled();
            }
        });
    }

    void start() {
        Thread worker = DedicatedThread.create(thread, this);
        worker.start();
    }
}
