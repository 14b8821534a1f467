package lightning.editor.window.widget;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.Slider;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.stage.Stage;
import lightning.base.math.Rgb;
import lightning.document.HsvColor;
import lightning.editor.window.JavaFxRequirement;
import lightning.editor.window.StageExtension;
import lightning.sample.Slow;
import lightning.scene.value.SceneLimits;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;

@ExtendWith({JavaFxRequirement.class, StageExtension.class})
@Slow
class ColorSlidersTest {
    private final List<Object> gestures = new ArrayList<>();
    private Rgb color = new Rgb(0.5, 0.25, 0.1);
    private ColorSliders sliders;

    @Start
    private void start(Stage stage) {
        sliders = new ColorSliders("", "", 1000, (change, gesture) -> {
            try {
                return edit(change.apply(color), gesture);
            } catch (IllegalArgumentException e) {
                return Optional.of(e.getMessage());
            }
        });
        sliders.show(color);
        stage.setScene(new Scene(sliders, 320, 320));
        stage.show();
    }

    private Optional<String> edit(Rgb edited, Object gesture) {
        gestures.add(gesture);
        color = edited;
        sliders.show(edited);
        return Optional.empty();
    }

    @Test
    void everyChannel_isShownInSliderAndField(FxRobot robot) {
        assertThat(sliders(robot)).extracting(Slider::getValue).containsExactly(0.5, 0.25, 0.1);
        assertThat(fields(robot)).extracting(TextField::getText).containsExactly("0.5", "0.25", "0.1");
    }

    @Test
    void draggingASlider_isOneGesture(FxRobot robot) {
        robot.drag(sliders(robot).get(2).lookup(".thumb")).moveBy(30, 0).moveBy(30, 0).release(MouseButton.PRIMARY);
        assertThat(color.b()).isBetween(0.3, 0.7);
        assertThat(color.r()).isEqualTo(0.5);
        assertThat(gestures).hasSizeGreaterThan(1).doesNotContainNull();
        assertThat(gestures.stream().distinct()).hasSize(1);
        assertThat(fields(robot).get(2).getText()).isEqualTo(SceneLimits.format(color.b()));
    }

    @Test
    void typedChannelAboveOne_isAcceptedWithSliderAtEnd(FxRobot robot) {
        type(robot, 0, "2.5");
        assertThat(color).isEqualTo(new Rgb(2.5, 0.25, 0.1));
        assertThat(sliders(robot).get(0).getValue()).isEqualTo(1);
    }

    @Test
    void typedNegativeChannel_isRefused(FxRobot robot) {
        type(robot, 1, "-1");
        assertThat(gestures).isEmpty();
        assertThat(RefusalTexts.shown(robot)).containsExactly("green must be ≥ 0, was -1");
    }

    @Test
    void hsvTab_showsAndSetsHueSaturationAndValue(FxRobot robot) {
        robot.interact(() -> sliders.show(new Rgb(0, 1, 0)));
        robot.clickOn("HSV");
        assertThat(fields(robot)).extracting(TextField::getText).containsExactly("120", "1", "1");
        type(robot, 0, "240");
        assertThat(color).isEqualTo(new Rgb(0, 0, 1));
    }

    @Test
    void hueBeyondTheCircle_isRefused(FxRobot robot) {
        robot.clickOn("HSV");
        type(robot, 0, "400");
        assertThat(gestures).isEmpty();
        assertThat(RefusalTexts.shown(robot)).containsExactly("hue must be from 0 to 360, was 400");
    }

    @Test
    void grayedColor_keepsHue(FxRobot robot) {
        robot.interact(() -> edit(new Rgb(0, 0, 1), null));
        robot.clickOn("HSV");
        type(robot, 1, "0");
        assertThat(color).isEqualTo(Rgb.WHITE);
        type(robot, 1, "1");
        assertThat(color).isEqualTo(new Rgb(0, 0, 1));
    }

    @Test
    void draggingInTheSquare_setsSaturationAndValue(FxRobot robot) {
        robot.interact(() -> edit(new Rgb(0.2, 0.1, 0.1), null));
        robot.clickOn("HSV");
        gestures.clear();
        double quarter = robot.lookup(".color-square").query().getLayoutBounds().getWidth() / 4;
        robot.drag(".color-square").moveBy(quarter, -40).release(MouseButton.PRIMARY);
        assertThat(HsvColor.of(color).saturation()).isCloseTo(0.75, within(0.01));
        assertThat(color.r()).isGreaterThan(0.6);
        assertThat(color.g()).isEqualTo(color.b());
        assertThat(gestures.stream().distinct()).hasSize(1);
    }

    @Test
    void disabledReason_disablesEveryTab(FxRobot robot) {
        robot.interact(() -> sliders.setDisabledReason(Optional.of("no light is selected")));
        assertThat(fields(robot)).allMatch(Node::isDisabled);
        robot.clickOn("HSV");
        assertThat(fields(robot)).hasSize(3);
    }

    @Test
    void well_opensThePicker(FxRobot robot) {
        robot.clickOn(".color-well");
        assertThat(robot.lookup(".color-square").query().isFocused()).isTrue();
        robot.push(KeyCode.RIGHT);
        assertThat(HsvColor.of(color).saturation()).isCloseTo(0.81, within(1e-9));
    }

    private static void type(FxRobot robot, int field, String text) {
        TextTyping.replace(robot, fields(robot).get(field), text).push(KeyCode.ENTER);
    }

    private static List<TextField> fields(FxRobot robot) {
        return robot.lookup(".number-field").queryAllAs(TextField.class).stream().toList();
    }

    private static List<Slider> sliders(FxRobot robot) {
        return robot.lookup(".color-slider").queryAllAs(Slider.class).stream().toList();
    }
}
