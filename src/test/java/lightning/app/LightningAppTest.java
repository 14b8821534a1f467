package lightning.app;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.scene.control.Label;
import javafx.stage.Stage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.ApplicationExtension;
import org.testfx.framework.junit5.Start;

@ExtendWith({JavaFxNeeds.class, ApplicationExtension.class})
class LightningAppTest {
    private Stage stage;

    @Start
    private void start(Stage primary) {
        stage = primary;
        new LightningApp().start(primary);
    }

    @Test
    void window_isShownWithItsGreeting(FxRobot robot) {
        assertThat(stage.isShowing()).isTrue();
        assertThat(robot.lookup("#greeting").queryAs(Label.class).getText()).isEqualTo("Lightning");
    }
}
