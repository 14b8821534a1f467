package lightning.editor.window.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import javafx.scene.control.Button;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.VBox;
import javafx.stage.Stage;
import lightning.document.StepRange;
import lightning.editor.window.JavaFxRequirement;
import lightning.editor.window.StageExtension;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;

@ExtendWith({JavaFxRequirement.class, StageExtension.class})
class NumberFieldTest {
    private static final String LONG = "0.49999999742";

    private NumberField field;

    @Start
    private void start(Stage stage) {
        field = new NumberField("Size", NumberSetting.of("size", new StepRange(0.1, 0, 100), (_, _) -> Optional.empty()));
        var button = new Button("Before");
        button.setId("before");
        field.setMaxWidth(60);
        stage.setScene(ColorTheme.scene(new VBox(button, field), 200, 100));
        stage.show();
        field.show(Double.parseDouble(LONG));
    }

    private void assertBeginningIsShown() {
        assertThat(field.getText()).isEqualTo(LONG);
        assertThat(field.getSelectedText()).isEqualTo(LONG);
        assertThat(field.getCaretPosition()).isZero();
    }

    @Test
    void click_selectsNumberAndShowsItsBeginning(FxRobot robot) {
        robot.clickOn(field);
        assertBeginningIsShown();
    }

    @Test
    void secondClick_placesCaret(FxRobot robot) {
        robot.clickOn(field);
        robot.sleep(600);
        robot.clickOn(field);
        assertThat(field.getSelectedText()).isEmpty();
    }

    @Test
    void tab_selectsNumberAndShowsItsBeginning(FxRobot robot) {
        robot.interact(() -> robot.lookup("#before").query().requestFocus());
        robot.push(KeyCode.TAB);
        assertBeginningIsShown();
    }

    @Test
    void typing_afterClick_replacesNumber(FxRobot robot) {
        robot.clickOn(field).write("2");
        assertThat(field.getText()).isEqualTo("2");
    }

    /** Its first digits alone would look like a smaller number. */
    @Test
    void largeNumber_isShownWithAnExponent(FxRobot robot) {
        robot.interact(() -> {
            robot.lookup("#before").query().requestFocus();
            field.show(2_753_500);
        });
        assertThat(field.getText()).isEqualTo("2.754e6");
        robot.interact(() -> field.show(-123_456.7));
        assertThat(field.getText()).isEqualTo("-123460");
        robot.interact(() -> field.show(1e9));
        assertThat(field.getText()).isEqualTo("1e9");
        robot.interact(() -> {
            field.show(2_753_500);
            field.requestFocus();
        });
        assertThat(field.getText()).as("while it is edited").isEqualTo("2753500");
    }
}
