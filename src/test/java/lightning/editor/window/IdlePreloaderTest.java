package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import javafx.scene.Group;
import javafx.scene.Scene;
import lightning.base.work.Await;
import lightning.editor.window.widget.TimeSlicedTask;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.util.WaitForAsyncUtils;

/** The preloader runs its steps only while the user is idle and no other work is running. */
@ExtendWith({JavaFxRequirement.class, StageExtension.class})
@Slow
class IdlePreloaderTest {
    private static final long LONGER_THAN_IDLE_MS = 1800;

    private final AtomicInteger stepsRun = new AtomicInteger();
    /** Task that never ends. */
    private final TimeSlicedTask slicedTask = new TimeSlicedTask(() -> true);
    private IdlePreloader preloader;

    /** Starts the endless task. Called after the stage is set up, because the robot waits until all time-sliced tasks are done. */
    private void start() {
        slicedTask.start();
        preloader = new IdlePreloader(new Scene(new Group()), () -> true,
                Stream.<Runnable>generate(() -> stepsRun::incrementAndGet).limit(3).iterator());
    }

    private static void onFxThread(Runnable step) {
        WaitForAsyncUtils.waitForAsyncFx(TimeUnit.SECONDS.toMillis(Await.TIMEOUT_SECONDS), step);
    }

    @Test
    void step_whileSlicedTaskRuns_waits() throws Exception {
        onFxThread(this::start);
        try {
            Thread.sleep(LONGER_THAN_IDLE_MS);
            assertThat(stepsRun).hasValue(0);
            onFxThread(slicedTask::cancel);
            WaitForAsyncUtils.waitFor(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS, () -> stepsRun.get() == 3);
        } finally {
            onFxThread(() -> {
                slicedTask.cancel();
                preloader.close();
            });
        }
    }
}
