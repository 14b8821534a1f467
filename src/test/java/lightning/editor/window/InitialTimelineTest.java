package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import javafx.scene.layout.Region;
import javafx.stage.Stage;
import lightning.base.work.Await;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import org.testfx.framework.junit5.Stop;
import org.testfx.util.WaitForAsyncUtils;

/** A scene with a shot opens with its timeline. */
@ExtendWith({JavaFxRequirement.class, StageExtension.class})
@Slow
class InitialTimelineTest {
    private LightningApp app;
    private volatile Editor editor;

    @Start
    private void start(Stage stage) throws Exception {
        app = new LightningApp() {
            @Override
            Path file() {
                return Path.of("scenes/dusk.jen");
            }

            @Override
            void editorOpened(Editor opened) {
                editor = opened;
            }
        };
        app.init();
        app.start(stage);
    }

    @Stop
    private void stop() {
        app.stop();
    }

    @Test
    void timeline_fitsItsRows(FxRobot robot) throws Exception {
        WaitForAsyncUtils.waitFor(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS,
                () -> editor != null && robot.lookup("#timeline").tryQuery().isPresent());
        FastRobot.settle();
        Region timeline = robot.lookup("#timeline").query();
        assertThat(timeline.getHeight()).isBetween(198.0, 290.0);
    }
}
