package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.MenuBar;
import javafx.scene.control.MenuItem;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCombination;
import javafx.stage.Window;
import lightning.editor.Command;
import lightning.editor.window.model.AccuracyMode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The palette finds every command by a few letters, and custom shortcuts run their commands. */
@OwnEditor
class CommandPaletteTest extends EditorFixture {
    @AfterEach
    void closeWindows() {
        robot.interact(() -> List.copyOf(Window.getWindows()).stream().filter(window -> window != stage).forEach(Window::hide));
    }

    private void find(String letters) {
        robot.push(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.P);
        robot.write(letters);
    }

    private boolean isOpen() {
        return robot.lookup("#palette").tryQuery().isPresent();
    }

    @Test
    void fewLetters_findCommandAndEnterRunsIt() {
        find("dup li");
        robot.push(KeyCode.ENTER);
        assertThat(isOpen()).isFalse();
        assertThat(model().editor().scene().lights()).hasSize(4);
    }

    @Test
    void enterWithoutLetters_runsNothing() {
        var before = model().editor().document();
        find("");
        robot.push(KeyCode.ENTER);
        assertThat(isOpen()).isTrue();
        robot.push(KeyCode.DOWN);
        assertThat(robot.lookup("#palette-about").<Label>query().getText()).isNotEmpty();
        robot.push(KeyCode.ESCAPE);
        assertThat(model().editor().document()).isSameAs(before);
    }

    @Test
    void commandValue_isFoundByItsMenu() {
        find("accuracy approximate");
        robot.push(KeyCode.ENTER);
        assertThat(model().accuracyModeProperty().get()).isEqualTo(AccuracyMode.RATIO);
    }

    @Test
    void disabledCommand_showsReasonAndStaysOpen() {
        find("undo");
        assertThat(robot.lookup("#palette-about").<Label>query().getText()).contains("Unavailable: nothing to undo.");
        robot.push(KeyCode.ENTER);
        assertThat(isOpen()).isTrue();
        robot.push(KeyCode.ESCAPE);
        assertThat(isOpen()).isFalse();
    }

    @Test
    void longReason_isShownInFull() {
        find("set keyframe");
        Label about = robot.lookup("#palette-about").query();
        assertThat(about.getText()).contains("Unavailable: ");
        assertThat(about.getHeight()).isGreaterThanOrEqualTo(about.prefHeight(about.getWidth()));
    }

    private void listenFor(Command command) {
        robot.interact(() -> model().commands().run(Command.KEYS));
        robot.interact(() -> {
            robot.lookup("#key-" + command.id()).<Button>query().requestFocus();
            robot.lookup("#key-" + command.id()).<Button>query().fire();
        });
    }

    private void closeKeys() {
        closeWindows();
        robot.interact(() -> stage.requestFocus());
    }

    @Test
    void assignedKey_replacesOldKeyImmediately() {
        listenFor(Command.DUPLICATE_LIGHT);
        robot.push(KeyCode.CONTROL, KeyCode.J);
        closeKeys();
        robot.push(KeyCode.CONTROL, KeyCode.J);
        assertThat(model().editor().scene().lights()).hasSize(4);
        robot.push(KeyCode.CONTROL, KeyCode.D);
        assertThat(model().editor().scene().lights()).hasSize(4);
        assertThat(text(Command.DUPLICATE_LIGHT)).isEqualTo("Ctrl+J");
    }

    /** Returns the shortcut that the menu bar shows. */
    private String text(Command command) {
        MenuItem item = robot.lookup(".menu-bar").<MenuBar>query().getMenus().stream().flatMap(m -> m.getItems().stream())
                .filter(i -> ("menu-" + command.id()).equals(i.getId())).findFirst().orElseThrow();
        return item.getAccelerator().getDisplayText();
    }

    @Test
    void keyInUse_isReassignedOnSecondPress() {
        listenFor(Command.DUPLICATE_LIGHT);
        robot.push(KeyCode.CONTROL, KeyCode.L);
        assertThat(robot.lookup("Ctrl+L is assigned to Add Light; press it again to reassign it").tryQuery()).isPresent();
        assertThat(model().commands().keyBindings().isChanged(Command.DUPLICATE_LIGHT)).isFalse();
        robot.push(KeyCode.CONTROL, KeyCode.L);
        assertThat(model().commands().keyBindings().binding(Command.DUPLICATE_LIGHT)).contains(KeyCombination.valueOf("Shortcut+L"));
        assertThat(robot.lookup("#key-add-light").<Button>query().getText()).isEqualTo("none");
        robot.interact(() -> robot.lookup("#reset-keys").<Button>query().fire());
        assertThat(robot.lookup("#key-add-light").<Button>query().getText()).isEqualTo("Ctrl+L");
    }

    @Test
    void singleLetterKey_isRefusedWithReason() {
        listenFor(Command.GO);
        robot.push(KeyCode.K);
        assertThat(robot.lookup("K needs Ctrl or Alt; only function keys work alone").tryQuery()).isPresent();
        robot.push(KeyCode.ESCAPE);
        assertThat(model().commands().keyBindings().isChanged(Command.GO)).isFalse();
    }
}
