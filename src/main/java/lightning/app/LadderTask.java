package lightning.app;

import javafx.concurrent.Task;
import lightning.accuracy.Ladder;
import lightning.accuracy.LadderMeter;
import lightning.edit.LastEdit;
import lightning.shading.Progress;
import lightning.shading.Workers;

/** Measures what each level of accuracy costs for an edit, on a thread of its own. */
final class LadderTask extends Task<Ladder> {
    private static final int REPETITIONS = 5;
    private static final double PATIENCE_MS = 1500;

    private final LastEdit edit;

    LadderTask(LastEdit edit) {
        this.edit = edit;
    }

    @Override
    protected Ladder call() {
        try (var meter = new LadderMeter(Workers.available(), REPETITIONS, PATIENCE_MS)) {
            return meter.measure(edit.before(), edit.after(), new Progress() {
                @Override
                public void tiles(int done, int total) {
                    updateProgress(done, total);
                }

                @Override
                public boolean isCancelled() {
                    return LadderTask.this.isCancelled();
                }
            });
        }
    }

    void begin() {
        Thread thread = new Thread(this, "lightning-ladder");
        thread.setDaemon(true);
        thread.start();
    }
}
