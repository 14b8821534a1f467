package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import javafx.scene.Group;
import javafx.scene.Scene;
import lightning.base.work.Wait;
import lightning.editor.window.widget.Slices;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.util.WaitForAsyncUtils;

/** What is made before it is wanted comes behind all else. */
@ExtendWith({JavaFxNeeds.class, OnStage.class})
@Slow
class AheadTest {
    private static final long LONGER_THAN_A_REST_MS = 1800;

    private final AtomicInteger made = new AtomicInteger();
    /** Goes on for ever. */
    private final Slices sliced = new Slices(() -> true);
    private Ahead ahead;

    /** Starts slices that never finish: after the stage is set up, whose robot waits until all slices have finished. */
    private void begin() {
        sliced.begin();
        ahead = new Ahead(new Scene(new Group()), () -> true, Stream.<Runnable>generate(() -> made::incrementAndGet).limit(3).iterator());
    }

    private static void onWindowsThread(Runnable step) {
        WaitForAsyncUtils.waitForAsyncFx(TimeUnit.SECONDS.toMillis(Wait.MOST_SECONDS), step);
    }

    @Test
    void stepWaits_whileAnythingComesInSlices() throws Exception {
        onWindowsThread(this::begin);
        try {
            Thread.sleep(LONGER_THAN_A_REST_MS);
            assertThat(made).hasValue(0);
            onWindowsThread(sliced::end);
            WaitForAsyncUtils.waitFor(Wait.MOST_SECONDS, TimeUnit.SECONDS, () -> made.get() == 3);
        } finally {
            onWindowsThread(() -> {
                sliced.end();
                ahead.close();
            });
        }
    }
}
