package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javafx.css.PseudoClass;
import javafx.scene.control.ListCell;
import javafx.scene.control.TableCell;
import javafx.scene.control.TableView;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.stage.Window;
import lightning.editor.Command;
import lightning.editor.window.widget.TextTyping;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Scene;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Clicking an edit in the list restores its state. */
@OwnEditor
class HistoryPaneTest extends EditorFixture {
    @AfterEach
    void closeWindows() {
        robot.interact(() -> List.copyOf(Window.getWindows()).stream().filter(window -> window != stage).forEach(Window::hide));
    }

    private void type(String widget, String text) {
        if (widget.equals("ambience")) {
            robot.interact(() -> model().commands().run(Command.EDIT_WORLD));
        }
        TextTyping.replace(robot, robot.lookup("#" + widget + " .number-field").<TextField>query(), text).push(KeyCode.ENTER);
    }

    private List<String> listedTexts(boolean undone) {
        return robot.lookup("#history-list .list-cell").queryAllAs(ListCell.class).stream().filter(c -> !c.isEmpty())
                .filter(c -> c.getPseudoClassStates().contains(PseudoClass.getPseudoClass("undone")) == undone)
                .map(c -> c.getText()).toList();
    }

    @Test
    void click_restoresThatEdit() {
        type("intensity", "2");
        Scene two = model().editor().scene();
        type("intensity", "3");
        type("ambience", "0.5");
        robot.interact(() -> model().commands().run(Command.HISTORY_PANEL));
        assertThat(listedTexts(false)).containsExactly("Opened", "lamp: intensity 1 → 2", "lamp: intensity 2 → 3",
                "ambient light 0.2 → 0.5");
        robot.clickOn("lamp: intensity 1 → 2");
        assertThat(model().editor().scene()).isEqualTo(two);
        assertThat(listedTexts(true)).containsExactly("lamp: intensity 2 → 3", "ambient light 0.2 → 0.5");
        click("go");
        waitForPicture();
        assertCanvasShows(new ReferenceTracer(two).trace());
        robot.clickOn("ambient light 0.2 → 0.5");
        assertThat(model().editor().scene().world().ambience()).isEqualTo(0.5);
        assertThat(light("lamp").intensity()).isEqualTo(3);
    }

    @Test
    void clickInLightHistory_keepsOtherLights() {
        type("intensity", "2");
        type("intensity", "3");
        type("ambience", "0.5");
        robot.interact(() -> model().commands().run(Command.HISTORY_PANEL));
        click("history-light");
        robot.clickOn("Opened");
        assertThat(light("lamp").intensity()).isEqualTo(1);
        assertThat(model().editor().scene().world().ambience()).isEqualTo(0.5);
        assertThat(listedTexts(true)).containsExactly("lamp: intensity 1 → 2", "lamp: intensity 2 → 3");
        robot.push(KeyCode.CONTROL, KeyCode.Z);
        assertThat(light("lamp").intensity()).isEqualTo(3);
    }

    @Test
    void status_opensUpdates() {
        type("intensity", "2");
        click("go");
        waitForPicture();
        click("status");
        List<String> details =
                robot.lookup("#updates-table .table-cell").queryAllAs(TableCell.class).stream().map(TableCell::getText).toList();
        assertThat(details).contains(model().picture().frame().update().plan().description(), "full render: no image yet");
        assertThat(model().updates().entries()).hasSize(2);
        assertThat(model().updates().entries().getFirst().update()).isSameAs(model().picture().frame().update());
    }

    @Test
    void updates_detailsFollowTheNewestImage() throws IOException {
        click("status");
        type("intensity", "2");
        click("go");
        waitForPicture();
        assertThat(text("updates-whole")).isEqualTo(model().updates().entries().getFirst().text());
        TableView<?> table = robot.lookup("#updates-table").query();
        robot.interact(() -> table.getSelectionModel().select(1));
        String older = text("updates-whole");
        type("intensity", "3");
        click("go");
        waitForPicture();
        assertThat(text("updates-whole")).as("details of the row that the user chose").isEqualTo(older);
    }

    @Test
    void openingAnotherFile_clearsUpdates() throws IOException {
        click("status");
        Path other = Files.writeString(folder.resolve("other.jen"), Files.readString(folder.resolve("desk.jen")));
        robot.interact(() -> editor.files().load(other));
        waitFor("the other scene is open", () -> model().editor().document().name().equals("other.jen"));
        waitForPicture();
        assertThat(model().updates().entries()).hasSize(1);
        assertThat(text("updates-whole")).isEqualTo(model().updates().entries().getFirst().text());
    }
}
