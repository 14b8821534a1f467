package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.atomic.AtomicInteger;
import javafx.scene.Scene;
import javafx.scene.control.Button;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.stage.Stage;
import lightning.sample.Slow;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxToolkit;
import org.testfx.util.WaitForAsyncUtils;

@ExtendWith(JavaFxRequirement.class)
@Slow
class FastRobotTest {
    private final FastRobot robot = new FastRobot();
    private final AtomicInteger clicks = new AtomicInteger();
    private Button button;
    private HBox row;
    private Stage stage;

    @BeforeEach
    void open() throws Exception {
        FxToolkit.registerPrimaryStage();
        FxToolkit.setupFixture(() -> {
            button = new Button("Press");
            row = new HBox(button);
            button.setId("press");
            button.setOnAction(_ -> clicks.incrementAndGet());
            stage = new Stage();
            stage.setScene(new Scene(row, 600, 200));
            stage.show();
        });
    }

    @AfterEach
    void close() throws Exception {
        FxToolkit.setupFixture(stage::close);
    }

    @Test
    void movedNode_isClickedAtItsNewPosition() {
        for (int i = 1; i <= 10; i++) {
            double width = 40 * i;
            WaitForAsyncUtils.waitForAsyncFx(10_000, () -> {
                var before = new Region();
                before.setMinWidth(width);
                row.getChildren().setAll(before, button);
            });
            robot.clickOn("#press");
            assertThat(clicks).hasValue(i);
        }
    }
}
