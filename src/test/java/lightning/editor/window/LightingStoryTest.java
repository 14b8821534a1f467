package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.scene.control.ComboBox;
import javafx.scene.control.MenuButton;
import javafx.scene.control.TextField;
import javafx.scene.control.Tooltip;
import javafx.scene.input.KeyCode;
import javafx.stage.Window;
import lightning.editor.Command;
import lightning.editor.window.widget.TextTyping;
import lightning.format.jen.JenReader;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Scene;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;

/** Lighting session from §2.3 of the paper: key light, fill light, rim light, and all corrections. */
class LightingStoryTest extends EditorFixture {

    private void type(String dial, String value) {
        TextTyping.replace(robot, robot.lookup("#" + dial + " .number-field").queryAs(TextField.class), value).push(KeyCode.ENTER);
    }

    private void add(int item) {
        MenuButton add = robot.lookup("#add-light").query();
        robot.interact(() -> add.getItems().get(item).fire());
    }

    private void rename(String name) {
        TextTyping.replace(robot, robot.lookup("#light-name").queryAs(TextField.class), name).push(KeyCode.ENTER);
    }

    private void changeType(LightType type) {
        ComboBox<LightType> types = robot.lookup("#light-type").query();
        robot.interact(() -> types.getSelectionModel().select(type));
    }

    /** Moves the mouse off the tool bar, so that a button's tooltip closes and does not receive the next click. */
    private void leaveToolBar() {
        robot.moveTo("#light-name");
        waitFor("no tooltip is shown", () -> Window.getWindows().stream().noneMatch(Tooltip.class::isInstance));
    }

    private void go() {
        leaveToolBar();
        click(Command.GO.id());
        waitForPicture();
    }

    private void mirrorsAndCompare() {
        if (isEnabled(Command.UPDATE_REFLECTIONS)) {
            click(Command.UPDATE_REFLECTIONS.id());
            waitForPicture();
        }
        assertFilmIs(new ReferenceTracer(model().editor().scene()).trace());
    }

    @Test
    void keyFillAndRim_withUndoTypeChangeSaveAndReload_matchFullTrace() throws Exception {
        // Make the key light brighter, then less blue.
        robot.interact(() -> model().editor().selection().selectLight("lamp"));
        rename("key");
        type("intensity", "1.6");
        go();
        type("color", "0.7");
        go();
        click(Command.UNDO.id());
        assertThat(isEnabled(Command.GO)).as("undoing after Go leaves Go enabled").isTrue();
        go();
        assertThat(light("key").color().r()).isEqualTo(1);
        mirrorsAndCompare();

        // A spot fills the shadows; then its attenuation, dropoff and type are changed.
        add(1);
        rename("fill");
        type("intensity", "0.6");
        type("linear", "0.2");
        type("dropoff", "3");
        go();
        changeType(LightType.POINT);
        go();
        assertThat(light("fill").dropoff()).as("kept though a point light has none").isEqualTo(3);
        mirrorsAndCompare();

        // The rim light is far too large.
        add(1);
        rename("rim");
        type("angle", "12");
        type("intensity", "0.9");
        go();
        mirrorsAndCompare();

        // Save, change, and reload the saved scene.
        Scene saved = model().editor().scene();
        click(Command.SAVE_SCENE.id());
        waitFor("the file holds the scene", () -> JenReader.read(folder.resolve("desk.jen")).scene().equals(saved));
        type("intensity", "0");
        go();
        click(Command.RELOAD.id());
        waitFor("the scene is as saved", () -> model().editor().scene().equals(saved));
        go();
        mirrorsAndCompare();
    }
}
