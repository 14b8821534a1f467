package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import javafx.scene.Node;
import javafx.scene.control.TabPane;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import lightning.editor.document.Desk;
import lightning.editor.window.widget.Typing;
import org.junit.jupiter.api.Test;

/** Undo is where the hands are: in a number field too. */
class UndoKeysTest extends EditorDesk {

    private TextField field(String query) {
        return robot.lookup(query).query();
    }

    private void enter(String query, String text) {
        Typing.over(robot, field(query), text).push(KeyCode.ENTER);
    }

    @Test
    void inANumberFieldThatIsSet_takeBackTheDocumentsLastEdit() {
        enter("#intensity .number-field", "4");
        robot.push(KeyCode.CONTROL, KeyCode.Z);
        assertThat(light("lamp").intensity()).isEqualTo(1);
        assertThat(field("#intensity .number-field").getText()).isEqualTo("1");
        robot.push(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.Z);
        assertThat(light("lamp").intensity()).isEqualTo(4);
    }

    @Test
    void controlY_isRedoToo() {
        enter("#intensity .number-field", "4");
        robot.push(KeyCode.CONTROL, KeyCode.Z).push(KeyCode.CONTROL, KeyCode.Y);
        assertThat(light("lamp").intensity()).isEqualTo(4);
        robot.interact(() -> preview().requestFocus());
        robot.push(KeyCode.CONTROL, KeyCode.Z).push(KeyCode.CONTROL, KeyCode.Y);
        assertThat(light("lamp").intensity()).isEqualTo(4);
    }

    @Test
    void whatIsTypedAndNotSet_isTakenBackFirst() {
        enter("#intensity .number-field", "4");
        Typing.over(robot, field("#intensity .number-field"), "7");
        robot.push(KeyCode.CONTROL, KeyCode.Z);
        assertThat(field("#intensity .number-field").getText()).isEqualTo("4");
        assertThat(light("lamp").intensity()).isEqualTo(4);
        robot.push(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.Z);
        assertThat(field("#intensity .number-field").getText()).isEqualTo("7");
        robot.push(KeyCode.CONTROL, KeyCode.Z).push(KeyCode.CONTROL, KeyCode.Z);
        assertThat(light("lamp").intensity()).isEqualTo(1);
    }

    @Test
    void inEveryTextOfTheWindow_reachTheDocument() {
        robot.interact(() -> robot.lookup("#side").<TabPane>query().getSelectionModel().select(1));
        robot.interact(() -> robot.lookup("#side").<TabPane>query().getSelectionModel().select(0));
        List<TextField> all = robot.lookup(n -> n instanceof TextField t && !t.isDisabled() && t.isEditable() && n.isFocusTraversable())
                .queryAllAs(TextField.class).stream().toList();
        assertThat(all).hasSizeGreaterThan(20);
        for (TextField text : all) {
            robot.interact(() -> {
                model().editor().edit(scene -> Desk.dial("intensity").set(scene, "sun", 3));
                text.requestFocus();
            });
            robot.push(KeyCode.CONTROL, KeyCode.Z);
            assertThat(light("sun").intensity()).as(named(text)).isEqualTo(0.4);
        }
    }

    private static String named(Node node) {
        return node.getAccessibleText();
    }
}
