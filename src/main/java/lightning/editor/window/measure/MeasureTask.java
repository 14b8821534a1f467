package lightning.editor.window.measure;

import java.util.function.Function;
import javafx.concurrent.Task;
import lightning.base.work.DedicatedThread;
import lightning.base.work.Progress;

/** Measures something on a thread of its own. */
final class MeasureTask<T> extends Task<T> {
    private final String thread;
    private final Function<Progress, T> work;

    /**
     * @param thread the thread's name
     * @param work   stops where its progress asks for it
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
