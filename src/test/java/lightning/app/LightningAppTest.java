package lightning.app;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.stage.Stage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.ApplicationExtension;
import org.testfx.framework.junit5.Start;
import org.testfx.framework.junit5.Stop;

@ExtendWith({JavaFxNeeds.class, ApplicationExtension.class})
class LightningAppTest {
    private final LightningApp app = new LightningApp();
    private Stage stage;

    @Start
    private void start(Stage primary) throws Exception {
        stage = primary;
        app.start(primary);
    }

    @Stop
    private void stop() {
        app.stop();
    }

    @Test
    void window_hasBothCanvasesAndWhatStandsBesideThem(FxRobot robot) {
        assertThat(stage.isShowing()).isTrue();
        for (String pane : new String[] {"#traced", "#preview", "#lights", "#properties"}) {
            assertThat(robot.lookup(pane).tryQuery()).as(pane).isPresent();
        }
    }
}
