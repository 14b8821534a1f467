package lightning.editor.window.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.event.EventType;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import javafx.scene.layout.VBox;
import javafx.stage.Stage;
import lightning.document.StepRange;
import lightning.editor.window.JavaFxRequirement;
import lightning.editor.window.StageExtension;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import org.testfx.service.query.PointQuery;

@ExtendWith({JavaFxRequirement.class, StageExtension.class})
@Slow
class ArrowWidgetTest {
    private static final double INITIAL_VALUE = 1.1;

    private final List<Object> gestures = new ArrayList<>();
    private double value = INITIAL_VALUE;
    private ArrowWidget widget;

    @Start
    private void start(Stage stage) {
        widget = new ArrowWidget("Gain", "gain", NumberSetting.of("gain", new StepRange(0.1, 0, 10), (v, gesture) -> {
            if (v < 0 || v > 10) {
                return Optional.of("gain must be from 0 to 10");
            }
            gestures.add(gesture);
            value = v;
            widget.show(v);
            return Optional.empty();
        }));
        widget.show(INITIAL_VALUE);
        stage.setScene(new Scene(new VBox(new TextField("elsewhere"), widget), 300, 200));
        stage.show();
    }

    @Test
    void clickOnTheUpperHalf_addsOneStep(FxRobot robot) {
        robot.clickOn(upper(robot));
        assertThat(value).isEqualTo(1.2);
        assertThat(field(robot).getText()).isEqualTo("1.2");
    }

    @Test
    void clickOnTheLowerHalf_subtractsOneStep(FxRobot robot) {
        robot.clickOn(lower(robot));
        assertThat(value).isEqualTo(1);
    }

    @Test
    void clickWithShift_isATenthOfAStep(FxRobot robot) {
        clickTop(robot, true, false);
        assertThat(value).isEqualTo(1.11);
    }

    @Test
    void clickWithControl_isTenSteps(FxRobot robot) {
        clickTop(robot, false, true);
        assertThat(value).isEqualTo(2.1);
    }

    @Test
    void clickAtLimit_changesNothing(FxRobot robot) {
        robot.interact(() -> widget.show(10.0));
        robot.clickOn(upper(robot));
        assertThat(value).isEqualTo(10);
    }

    @Test
    void dragUp_raisesTheValueInOneGesture(FxRobot robot) {
        robot.drag(robot.point(pad(robot)).atPosition(Pos.CENTER).atOffset(0, 10)).moveBy(0, -20).release(MouseButton.PRIMARY);
        assertThat(value).isEqualTo(1.6);
        assertThat(gestures).hasSizeGreaterThan(1).doesNotContainNull();
        assertThat(gestures.stream().distinct()).hasSize(1);
    }

    @Test
    void twoDrags_areTwoGestures(FxRobot robot) {
        robot.drag(pad(robot)).moveBy(0, -10).release(MouseButton.PRIMARY);
        robot.drag(pad(robot)).moveBy(0, 10).release(MouseButton.PRIMARY);
        assertThat(gestures.stream().distinct()).hasSize(2);
    }

    @Test
    void dragBackToStart_pastLimit_restoresValue(FxRobot robot) {
        robot.interact(() -> widget.show(0.1));
        robot.drag(pad(robot)).moveBy(0, 10);
        assertThat(value).isZero();
        robot.moveBy(0, -10).release(MouseButton.PRIMARY);
        assertThat(value).isEqualTo(0.1);
    }

    @Test
    void escape_duringDrag_restoresValue(FxRobot robot) {
        robot.drag(pad(robot)).moveBy(0, -8);
        assertThat(value).isEqualTo(1.3);
        robot.push(KeyCode.ESCAPE).moveBy(0, -4).release(MouseButton.PRIMARY);
        assertThat(value).isEqualTo(INITIAL_VALUE);
    }

    @Test
    void typedValue_isSetByEnter(FxRobot robot) {
        type(robot, "3.25");
        robot.push(KeyCode.ENTER);
        assertThat(value).isEqualTo(3.25);
    }

    @Test
    void typedValue_isSetByLeavingTheField(FxRobot robot) {
        type(robot, "3.25");
        robot.push(KeyCode.TAB);
        assertThat(value).isEqualTo(3.25);
    }

    @Test
    void typedValueBeyondLimit_showsReasonAndChangesNothing(FxRobot robot) {
        type(robot, "-3");
        robot.push(KeyCode.ENTER);
        assertThat(gestures).isEmpty();
        assertThat(isMarked(robot)).isTrue();
        assertThat(RefusalTexts.shown(robot)).containsExactly("gain must be from 0 to 10");
    }

    @Test
    void typedText_isRefused(FxRobot robot) {
        type(robot, "much");
        robot.push(KeyCode.ENTER);
        assertThat(gestures).isEmpty();
        assertThat(RefusalTexts.shown(robot)).containsExactly("gain must be a number, was 'much'");
    }

    @Test
    void typedSum_isEvaluated(FxRobot robot) {
        type(robot, "0.3*2");
        robot.push(KeyCode.ENTER);
        assertThat(value).isEqualTo(0.6);
        assertThat(field(robot).getText()).isEqualTo("0.6");
    }

    @Test
    void typedPercentage_isRelativeToCurrentValue(FxRobot robot) {
        type(robot, "+10%");
        robot.push(KeyCode.ENTER);
        assertThat(value).isEqualTo(1.21);
    }

    @Test
    void invalidSum_showsPosition(FxRobot robot) {
        type(robot, "2*");
        robot.push(KeyCode.ENTER);
        assertThat(gestures).isEmpty();
        assertThat(RefusalTexts.shown(robot))
                .containsExactly("gain must be a number or an expression such as 0.3*2: expected a number after '2*', found the end");
    }

    @Test
    void dragOfTheNameToTheRight_raisesTheValueInOneGesture(FxRobot robot) {
        robot.drag("Gain").moveBy(12, 0).moveBy(8, 0).release(MouseButton.PRIMARY);
        assertThat(value).isEqualTo(1.6);
        assertThat(gestures).hasSizeGreaterThan(1).doesNotContainNull();
        assertThat(gestures.stream().distinct()).hasSize(1);
    }

    @Test
    void clickOnName_focusesField(FxRobot robot) {
        robot.clickOn("Gain").write("7").push(KeyCode.ENTER);
        assertThat(value).isEqualTo(7);
    }

    @Test
    void wheel_inFocusedField_stepsInOneGesture(FxRobot robot) {
        turnWheel(robot, 40);
        assertThat(gestures).isEmpty();
        robot.interact(() -> field(robot).requestFocus());
        turnWheel(robot, 40);
        turnWheel(robot, 40);
        assertThat(value).isEqualTo(1.3);
        turnWheel(robot, -40);
        assertThat(value).isEqualTo(1.2);
        assertThat(gestures.stream().distinct()).hasSize(1);
    }

    /** Synthesizes wheel events without a delay between them. */
    private static void turnWheel(FxRobot robot, double delta) {
        robot.interact(
                () -> field(robot).fireEvent(new ScrollEvent(ScrollEvent.SCROLL, 2, 2, 2, 2, false, false, false, false, false, false, 0,
                        delta, 0, delta, ScrollEvent.HorizontalTextScrollUnits.NONE, 0, ScrollEvent.VerticalTextScrollUnits.NONE, 0, 0,
                        null)));
    }

    @Test
    void escape_restoresValueAndClearsError(FxRobot robot) {
        type(robot, "-3");
        robot.push(KeyCode.ENTER).push(KeyCode.ESCAPE);
        assertThat(field(robot).getText()).isEqualTo("1.1");
        assertThat(isMarked(robot)).isFalse();
        assertThat(RefusalTexts.shown(robot)).isEmpty();
    }

    @Test
    void escapeWhileTyping_setsNothing(FxRobot robot) {
        type(robot, "5");
        robot.push(KeyCode.ESCAPE).push(KeyCode.TAB);
        assertThat(gestures).isEmpty();
    }

    @Test
    void upAndDownKeys_step(FxRobot robot) {
        robot.clickOn(field(robot)).push(KeyCode.UP).push(KeyCode.UP).push(KeyCode.DOWN).push(KeyCode.PAGE_UP);
        assertThat(value).isEqualTo(2.2);
    }

    @Test
    void leavingAFieldUntouched_editsNothing(FxRobot robot) {
        robot.interact(() -> widget.show(1.23456789));
        assertThat(field(robot).getText()).isEqualTo("1.2346");
        robot.clickOn(field(robot));
        assertThat(field(robot).getText()).isEqualTo("1.23456789");
        robot.push(KeyCode.TAB);
        assertThat(gestures).isEmpty();
    }

    @Test
    void disabledReason_disablesFieldAndArrow(FxRobot robot) {
        robot.interact(() -> widget.setDisabledReason(Optional.of("a point light has no angle")));
        assertThat(field(robot).isDisabled()).isTrue();
        robot.clickOn(upper(robot));
        assertThat(value).isEqualTo(INITIAL_VALUE);
        robot.interact(() -> widget.setDisabledReason(Optional.empty()));
        assertThat(field(robot).isDisabled()).isFalse();
    }

    /** Synthesizes mouse events with modifier keys, which the robot does not support. */
    private static void clickTop(FxRobot robot, boolean shift, boolean control) {
        robot.interact(() -> {
            for (EventType<MouseEvent> type : List.of(MouseEvent.MOUSE_PRESSED, MouseEvent.MOUSE_RELEASED)) {
                pad(robot).fireEvent(new MouseEvent(type, 2, 2, 2, 2, MouseButton.PRIMARY, 1, shift, control, false, false,
                        true, false, false, false, false, true, null));
            }
        });
    }

    private static void type(FxRobot robot, String text) {
        TextTyping.replace(robot, field(robot), text);
    }

    private static TextField field(FxRobot robot) {
        return robot.lookup(".number-field").queryAs(TextField.class);
    }

    private static Node pad(FxRobot robot) {
        return robot.lookup(".arrow-pad").query();
    }

    private static PointQuery upper(FxRobot robot) {
        return robot.point(pad(robot)).atPosition(Pos.CENTER).atOffset(0, -6);
    }

    private static PointQuery lower(FxRobot robot) {
        return robot.point(pad(robot)).atPosition(Pos.CENTER).atOffset(0, 6);
    }

    private static boolean isMarked(FxRobot robot) {
        return field(robot).getPseudoClassStates().contains(PseudoClass.getPseudoClass("refused"));
    }
}
