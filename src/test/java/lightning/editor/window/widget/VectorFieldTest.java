package lightning.editor.window.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.event.EventType;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.stage.Stage;
import lightning.base.math.Vec3;
import lightning.editor.window.JavaFxRequirement;
import lightning.editor.window.StageExtension;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;

@ExtendWith({JavaFxRequirement.class, StageExtension.class})
@Slow
class VectorFieldTest {
    private final List<Vec3> edits = new ArrayList<>();
    private VectorField vector;

    @Start
    private void start(Stage stage) {
        vector = new VectorField("direction", (v, _) -> {
            if (v.equals(Vec3.ZERO)) {
                return Optional.of("direction must not be zero");
            }
            edits.add(v);
            vector.show(v);
            return Optional.empty();
        });
        vector.show(new Vec3(0, -1, 0));
        stage.setScene(new Scene(vector, 320, 120));
        stage.show();
    }

    @Test
    void typedComponent_changesOnlyItself(FxRobot robot) {
        type(robot, 2, "0.5");
        assertThat(edits).containsExactly(new Vec3(0, -1, 0.5));
    }

    @Test
    void invalidComponent_showsReasonAndChangesNothing(FxRobot robot) {
        type(robot, 1, "0");
        assertThat(edits).isEmpty();
        assertThat(RefusalTexts.shown(robot)).containsExactly("direction must not be zero");
    }

    @Test
    void upKey_addsATenth(FxRobot robot) {
        robot.clickOn(fields(robot).get(1)).push(KeyCode.UP);
        assertThat(edits).containsExactly(new Vec3(0, -0.9, 0));
    }

    @Test
    void dragOfALetter_changesThatComponent(FxRobot robot) {
        Node letter = robot.lookup("Z").query();
        robot.interact(() -> {
            drag(letter, MouseEvent.MOUSE_PRESSED, 100);
            drag(letter, MouseEvent.MOUSE_DRAGGED, 112);
            drag(letter, MouseEvent.MOUSE_DRAGGED, 120);
            drag(letter, MouseEvent.MOUSE_RELEASED, 120);
        });
        assertThat(edits.getLast()).isEqualTo(new Vec3(0, -1, 0.5));
    }

    /** Synthesizes drag events: the headless window sends drags to the node under the mouse, other platforms to the pressed node. */
    private static void drag(Node letter, EventType<MouseEvent> type, double x) {
        letter.fireEvent(
                new MouseEvent(type, x, 2, x, 2, MouseButton.PRIMARY, 1, false, false, false, false, true, false, false, false, false,
                        true, null));
    }

    @Test
    void tab_focusesNextField(FxRobot robot) {
        robot.interact(() -> fields(robot).getFirst().requestFocus());
        robot.push(KeyCode.TAB);
        assertThat(fields(robot).get(1).isFocused()).isTrue();
        robot.push(KeyCode.TAB);
        assertThat(fields(robot).get(2).isFocused()).isTrue();
    }

    @Test
    void fields_areNamedForScreenReaders(FxRobot robot) {
        assertThat(fields(robot)).extracting(TextField::getAccessibleText)
                .containsExactly("direction x", "direction y", "direction z");
    }

    private static void type(FxRobot robot, int field, String text) {
        TextTyping.replace(robot, fields(robot).get(field), text).push(KeyCode.ENTER);
    }

    private static List<TextField> fields(FxRobot robot) {
        return robot.lookup(".number-field").queryAllAs(TextField.class).stream().toList();
    }
}
