package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import javafx.scene.Group;
import javafx.scene.Scene;
import javafx.stage.Stage;
import lightning.base.work.Wait;
import lightning.editor.window.widget.Slices;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.framework.junit5.Start;
import org.testfx.framework.junit5.Stop;
import org.testfx.util.WaitForAsyncUtils;

/** What is made before it is wanted comes behind all else. */
@ExtendWith({JavaFxNeeds.class, OnStage.class})
class AheadTest {
    private static final long LONGER_THAN_A_REST_MS = 1800;

    private final AtomicInteger made = new AtomicInteger();
    /** Goes on for ever. */
    private final Slices sliced = new Slices(() -> true);
    private Ahead ahead;

    @Start
    void open(Stage stage) {
        sliced.begin();
        ahead = new Ahead(new Scene(new Group()), () -> true, Stream.<Runnable>generate(() -> made::incrementAndGet).limit(3).iterator());
    }

    @Stop
    void close() {
        sliced.end();
        ahead.close();
    }

    @Test
    void stepWaits_whileAnythingComesInSlices() throws Exception {
        Thread.sleep(LONGER_THAN_A_REST_MS);
        assertThat(made).hasValue(0);
        WaitForAsyncUtils.waitForAsyncFx(TimeUnit.SECONDS.toMillis(Wait.MOST_SECONDS), sliced::end);
        WaitForAsyncUtils.waitFor(Wait.MOST_SECONDS, TimeUnit.SECONDS, () -> made.get() == 3);
    }
}
