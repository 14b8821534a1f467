package lightning.editor.window.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Predicate;
import javafx.scene.Node;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;
import javafx.scene.control.MenuItem;
import javafx.scene.control.ToggleButton;
import lightning.document.look.LookFiles;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.OwnEditor;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.junit.jupiter.api.Test;

/** Reviews that are opened in the editor. */
class ReviewActionsTest extends EditorFixture {
    private Path review(String reviewer, Light lamp) throws IOException {
        return Files.writeString(folder.resolve("review.json"),
                """
                        {"lightning_review": 1, "scene": "x", "reviewer": "REVIEWER", "exposure": 0, "groups": [], "notes": [], "lights": [
                          {"name": "lamp", "stops": 1, "tint": [1, 1, 1], "intensity": INTENSITY, "color": [1, 1, 1], "mute": false, "solo": false}]}
                        """
                        .replace("REVIEWER", reviewer).replace("INTENSITY", Double.toString(lamp.intensity())));
    }

    private void open(Path file) {
        answer = file;
        robot.interact(() -> model().commands().run(Command.OPEN_REVIEW));
    }

    @Test
    @OwnEditor
    void review_isAnEditAndTwoLooksBesideEachOther() throws IOException {
        Scene before = model().editor().scene();
        Light lamp = light("lamp");
        open(review("A: \\\"<b>", lamp));
        waitFor("the lamp is as reviewed", () -> light("lamp").intensity() == 2 * lamp.intensity());
        waitFor("both looks are chosen", () -> isChosen("look-a-Before the review of A_ __b_") && isChosen("look-b-Review of A_ __b_"));
        LookFiles looks = model().editor().looksFolder();
        assertThat(looks.list(before.stage())).extracting("name").contains("Before the review of A_ __b_", "Review of A_ __b_");
        assertThat(looks.list(before.stage()).stream().filter(look -> look.name().startsWith("Review")).findFirst().orElseThrow().lighting()
                .orElseThrow().rig().light("lamp").orElseThrow().intensity()).isEqualTo(2 * lamp.intensity());
        robot.interact(() -> model().commands().run(Command.UNDO));
        assertThat(model().editor().scene()).isEqualTo(before);
    }

    @Test
    @OwnEditor
    void pageOfTheShot_hasItsFrames() throws IOException {
        robot.interact(() -> {
            model().commands().run(Command.NEW_SHOT);
            model().editor().editShot(s -> s.withShot(s.shot().orElseThrow().withFrames(1, 3)), null);
        });
        answer = folder.resolve("film.html");
        robot.interact(() -> exportItem("Review Page of the Shot…").fire());
        waitFor("the page is written", () -> Files.exists(answer));
        assertThat(Files.readString(answer)).contains("\"frame\":1", "\"frame\":2", "\"frame\":3");
    }

    private MenuItem exportItem(String title) {
        return robot.lookup(".menu-bar").<MenuBar>query().getMenus().stream().flatMap(menu -> menu.getItems().stream())
                .filter(Menu.class::isInstance).flatMap(menu -> ((Menu) menu).getItems().stream())
                .filter(item -> title.equals(item.getText())).findFirst().orElseThrow();
    }

    private boolean isChosen(String id) {
        return robot.lookup((Predicate<Node>) node -> id.equals(node.getId())).tryQuery().map(node -> ((ToggleButton) node).isSelected())
                .orElse(false);
    }
}
