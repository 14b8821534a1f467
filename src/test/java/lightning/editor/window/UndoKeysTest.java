package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import javafx.scene.Node;
import javafx.scene.control.TabPane;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import lightning.document.DeskScene;
import lightning.editor.window.widget.TextTyping;
import org.junit.jupiter.api.Test;

/** The undo shortcut works wherever the focus is, including number fields. */
class UndoKeysTest extends EditorFixture {

    private TextField field(String query) {
        return robot.lookup(query).query();
    }

    private void enter(String query, String text) {
        TextTyping.replace(robot, field(query), text).push(KeyCode.ENTER);
    }

    @Test
    void undo_inCommittedNumberField_undoesDocumentEdit() {
        enter("#intensity .number-field", "4");
        robot.push(KeyCode.CONTROL, KeyCode.Z);
        assertThat(light("lamp").intensity()).isEqualTo(1);
        assertThat(field("#intensity .number-field").getText()).isEqualTo("1");
        robot.push(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.Z);
        assertThat(light("lamp").intensity()).isEqualTo(4);
    }

    @Test
    void controlY_redoes() {
        enter("#intensity .number-field", "4");
        robot.push(KeyCode.CONTROL, KeyCode.Z).push(KeyCode.CONTROL, KeyCode.Y);
        assertThat(light("lamp").intensity()).isEqualTo(4);
        robot.interact(() -> preview().requestFocus());
        robot.push(KeyCode.CONTROL, KeyCode.Z).push(KeyCode.CONTROL, KeyCode.Y);
        assertThat(light("lamp").intensity()).isEqualTo(4);
    }

    @Test
    void undo_ofUncommittedText_comesFirst() {
        enter("#intensity .number-field", "4");
        TextTyping.replace(robot, field("#intensity .number-field"), "7");
        robot.push(KeyCode.CONTROL, KeyCode.Z);
        assertThat(field("#intensity .number-field").getText()).isEqualTo("4");
        assertThat(light("lamp").intensity()).isEqualTo(4);
        robot.push(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.Z);
        assertThat(field("#intensity .number-field").getText()).isEqualTo("7");
        robot.push(KeyCode.CONTROL, KeyCode.Z).push(KeyCode.CONTROL, KeyCode.Z);
        assertThat(light("lamp").intensity()).isEqualTo(1);
    }

    @Test
    void undo_inAnyTextField_reachesDocument() {
        robot.interact(() -> robot.lookup("#side").<TabPane>query().getSelectionModel().select(1));
        robot.interact(() -> robot.lookup("#side").<TabPane>query().getSelectionModel().select(0));
        List<TextField> all = robot.lookup(n -> n instanceof TextField t && !t.isDisabled() && t.isEditable() && n.isFocusTraversable())
                .queryAllAs(TextField.class).stream().toList();
        assertThat(all).hasSizeGreaterThan(20);
        for (TextField text : all) {
            robot.interact(() -> {
                model().editor().edit(scene -> DeskScene.parameter("intensity").set(scene, "sun", 3));
                text.requestFocus();
            });
            robot.push(KeyCode.CONTROL, KeyCode.Z);
            assertThat(light("sun").intensity()).as(describe(text)).isEqualTo(0.4);
        }
    }

    private static String describe(Node node) {
        return node.getAccessibleText();
    }
}
