package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import javafx.scene.Node;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCombination;
import javafx.stage.Stage;
import javafx.stage.Window;
import lightning.document.DeskScene;
import lightning.editor.Command;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The commands' shortcuts work in the secondary windows as in the main window. */
class PanelShortcutsTest extends EditorFixture {
    private static final List<Command> PANELS =
            List.of(Command.ACCURACY_PANEL, Command.COMPARE_SETTINGS, Command.EFFECTS_PANEL, Command.KEYS, Command.SCOPES,
                    Command.HISTORY_PANEL, Command.UPDATES_PANEL, Command.MIXER, Command.LOOKS, Command.CONTRIBUTIONS, Command.LIGHT_LINKS);

    @BeforeEach
    void openPanelsInWindows() {
        floatPanels();
    }

    @AfterEach
    void closeWindows() {
        robot.interact(() -> panels().forEach(Window::hide));
    }

    private List<Window> panels() {
        return List.copyOf(Window.getWindows()).stream().filter(window -> window != stage).toList();
    }

    private Stage open(Command command) {
        robot.interact(() -> model().commands().run(command));
        waitFor(command + " is open and has the keyboard", () -> panels().size() == 1 && panels().getFirst().isFocused());
        return (Stage) panels().getFirst();
    }

    @Test
    void everyPanel_supportsUndoGoAndToggles() {
        robot.interact(() -> model().editor().edit(scene -> DeskScene.parameter("intensity").set(scene, "sun", 3)));
        boolean live = false;
        for (Command command : PANELS) {
            Stage panel = open(command);
            assertThat(panel.getTitle()).isEqualTo(command.plainTitle());
            robot.push(KeyCode.CONTROL, KeyCode.Z);
            assertThat(light("sun").intensity()).as("undone in %s", command).isEqualTo(0.4);
            robot.push(KeyCode.CONTROL, KeyCode.Y);
            assertThat(light("sun").intensity()).as("done again in %s", command).isEqualTo(3);
            robot.push(KeyCode.F8);
            assertThat(model().editor().liveProperty().get()).as("Live by the key in %s", command).isNotEqualTo(live);
            live = !live;
            robot.push(KeyCode.ESCAPE);
            assertThat(panels()).isEmpty();
        }
    }

    @Test
    void keyOfDisabledCommand_showsReason() {
        String why = "Render: nothing to render";
        robot.push(KeyCode.F5);
        assertThat(model().editor().message().textProperty().get()).isEqualTo(why);
        robot.push(KeyCode.ESCAPE);
        assertThat(model().editor().message().textProperty().get()).as("to cancel nothing needs no words").isEqualTo(why);
        robot.interact(() -> model().editor().message().show(""));
        open(Command.MIXER);
        robot.push(KeyCode.F5);
        assertThat(model().editor().message().textProperty().get()).isEqualTo(why);
    }

    @Test
    void goInPanel_showsScene() {
        open(Command.HISTORY_PANEL);
        robot.interact(() -> model().editor().edit(scene -> DeskScene.parameter("intensity").set(scene, "sun", 3)));
        robot.push(KeyCode.F5);
        waitForPicture();
        assertThat(model().picture().frame().scene()).isEqualTo(model().editor().scene());
    }

    /** The mixer keeps its search for the next scene. */
    @Test
    @OwnEditor
    void typedText_runsNoCommand() {
        open(Command.MIXER);
        TextField search = robot.lookup("#mixer-search").query();
        robot.interact(() -> {
            search.setText("sun");
            search.requestFocus();
            search.selectAll();
        });
        robot.push(KeyCode.SHORTCUT, KeyCode.C).push(KeyCode.SHORTCUT, KeyCode.DELETE);
        assertThat(model().editor().scene().lights()).hasSize(3);
        robot.push(KeyCode.F8);
        assertThat(model().editor().liveProperty().get()).isTrue();
    }

    @Test
    void changedKey_works() {
        open(Command.MIXER);
        robot.interact(() -> model().commands().keyBindings().set(Command.LIVE,
                Optional.of(KeyCombination.valueOf("Shortcut+J"))));
        robot.interact(() -> robot.lookup("#fader-lamp").<Node>query().requestFocus());
        robot.push(KeyCode.F8);
        assertThat(model().editor().liveProperty().get()).isFalse();
        robot.push(KeyCode.CONTROL, KeyCode.J);
        assertThat(model().editor().liveProperty().get()).isTrue();
    }
}
