package lightning.editor.window.welcome;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicInteger;
import javafx.event.EventHandler;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.CheckBox;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.image.ImageView;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import lightning.document.LightEdits;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.OwnEditor;
import lightning.format.jen.JenFile;
import org.junit.jupiter.api.Test;

class WelcomePaneTest extends EditorFixture {
    private void showPage() {
        robot.interact(() -> model().commands().run(Command.WELCOME));
        waitFor("the page is shown", () -> robot.lookup("#welcome").tryQuery().isPresent());
    }

    private boolean isPageShown() {
        return robot.lookup("#welcome").tryQuery().isPresent();
    }

    @Test
    void everyShippedScene_isListedWithThumbnail() throws IOException {
        try (var files = Files.list(Path.of("scenes"))) {
            assertThat(files.filter(Files::isRegularFile).map(f -> JenFile.stem(f.getFileName().toString())))
                    .containsExactlyInAnyOrderElementsOf(ShippedScene.ALL.stream().map(ShippedScene::name).toList());
        }
        showPage();
        for (ShippedScene scene : ShippedScene.ALL) {
            ImageView picture = robot.lookup("#scene-" + scene.name() + " .image-view").query();
            waitFor("the thumbnail is read", () -> picture.getImage().getProgress() == 1);
            assertThat(picture.getImage().isError()).as(scene.name()).isFalse();
            assertThat(picture.getImage().getWidth()).as(scene.name()).isEqualTo(ShippedScene.THUMBNAIL_WIDTH);
        }
    }

    @Test
    void thumbnail_opensCopyAndClosesPage() {
        showPage();
        robot.interact(() -> robot.lookup("#scene-softbox").<Button>query().fire());
        waitFor("the scene is open", () -> model().editor().document().name().equals("softbox.jen"));
        assertThat(model().editor().document().isUntitled()).isTrue();
        assertThat(isPageShown()).isFalse();
    }

    @Test
    void escape_closesPage() {
        showPage();
        robot.push(KeyCode.ESCAPE);
        assertThat(isPageShown()).isFalse();
    }

    /** A press that nothing handles would run the command with this shortcut: Cancel. */
    @Test
    void lateEscape_isIgnoredOnce() {
        var presses = new AtomicInteger();
        EventHandler<KeyEvent> counter = _ -> presses.incrementAndGet();
        robot.interact(() -> preview().getScene().addEventHandler(KeyEvent.KEY_PRESSED, counter));
        try {
            showPage();
            robot.push(KeyCode.ESCAPE);
            robot.push(KeyCode.ESCAPE);
            assertThat(presses).hasValue(0);
            robot.push(KeyCode.ESCAPE);
            assertThat(presses).hasValue(1);
            showPage();
            robot.interact(() -> robot.lookup("#scene-softbox").<Button>query().fire());
            waitFor("the scene is open", () -> model().editor().document().name().equals("softbox.jen"));
            robot.push(KeyCode.ESCAPE);
            assertThat(presses).hasValue(1);
            showPage();
            robot.push(KeyCode.ESCAPE);
            robot.push(KeyCode.SHIFT);
            robot.push(KeyCode.ESCAPE);
            assertThat(presses).hasValue(3);
        } finally {
            robot.interact(() -> preview().getScene().removeEventHandler(KeyEvent.KEY_PRESSED, counter));
        }
    }

    @Test
    void tab_reachesCardsAndScrollsToThem() {
        showPage();
        for (int i = 0; i < 40 && !"scene-bird".equals(focused().getId()); i++) {
            robot.push(KeyCode.TAB);
        }
        assertThat(focused().getId()).isEqualTo("scene-bird");
        Node page = robot.lookup("#welcome").query();
        assertThat(focused().localToScene(focused().getLayoutBounds()).getMaxY())
                .isLessThanOrEqualTo(page.localToScene(page.getLayoutBounds()).getMaxY());
    }

    private Node focused() {
        return robot.lookup("#welcome").query().getScene().getFocusOwner();
    }

    @Test
    @OwnEditor
    void showAtStart_isStored() {
        showPage();
        robot.interact(() -> robot.lookup("#welcome-show").<CheckBox>query().setSelected(false));
        assertThat(model().layout().welcomeAtStartProperty().get()).isFalse();
        waitFor("the choice is written", () -> Files.exists(folder.resolve("own/preferences.properties"))
                && Files.readString(folder.resolve("own/preferences.properties")).contains("welcome=false"));
    }

    @Test
    @OwnEditor
    void recentFiles_areOffered() throws IOException {
        Path second = Files.copy(model().editor().document().file(), folder.resolve("second.jen"));
        robot.interact(() -> editor.files().load(second));
        waitFor("the file is open", () -> model().editor().document().file().equals(second));
        showPage();
        waitFor("the list is read", () -> robot.lookup("#welcome-recent .button").queryAll().size() == 2);
    }

    private void startLesson(int index) {
        showPage();
        robot.interact(() -> robot.lookup("#lesson-" + index).<Button>query().fire());
        assertThat(isPageShown()).isFalse();
        assertThat(isShown("lesson-bar")).isTrue();
    }

    private void assertStep(int number, int count) {
        robot.interact(() -> {});
        assertThat(robot.lookup("#lesson-title").<Label>query().getText()).endsWith("(" + number + " of " + count + ")");
    }

    private void assertDone() {
        robot.interact(() -> {});
        assertThat(text("lesson-text")).isEqualTo("Done.");
    }

    @Test
    void lessonOfMovedLight_advancesWithEditVerifyAndUndo() {
        startLesson(0);
        assertStep(1, 3);
        robot.interact(() -> model().editor().edit(s -> LightEdits.edit(s, "lamp", l -> l.withIntensity(3))));
        assertStep(2, 3);
        assertThat(text("lesson-text")).contains("F7");
        robot.interact(() -> model().commands().run(Command.GO));
        waitForPicture();
        robot.interact(() -> model().commands().run(Command.VERIFY));
        assertStep(3, 3);
        robot.interact(() -> model().commands().run(Command.UNDO));
        assertDone();
        click("lesson-next");
        assertStep(1, 4);
        click("lesson-end");
        assertThat(isShown("lesson-bar")).isFalse();
    }

    @Test
    void lessonOfRimLight_countsEachDragOnce() {
        startLesson(1);
        robot.interact(() -> model().commands().run(Command.ADD_LIGHT));
        assertStep(2, 4);
        robot.interact(() -> model().commands().run(Command.GO));
        waitForPicture();
        robot.interact(() -> model().commands().run(Command.PLACE_RIM));
        assertStep(3, 4);
        robot.moveTo("#traced-picture").press(MouseButton.PRIMARY).moveBy(6, 0).moveBy(6, 0);
        assertStep(3, 4);
        robot.release(MouseButton.PRIMARY);
        assertStep(4, 4);
    }

    @Test
    void lessonOfMix_skipsSaveOfScenesWithFile() {
        startLesson(2);
        robot.interact(() -> model().commands().run(Command.MIXER));
        assertStep(2, 4);
        robot.interact(() -> model().editor().edit(s -> LightEdits.edit(s, "lamp", l -> l.withIntensity(3))));
        assertStep(4, 4);
        robot.interact(() -> model().commands().run(Command.GO));
        waitForPicture();
        robot.interact(() -> model().commands().run(Command.LOOKS));
        waitFor("the looks are shown", () -> robot.lookup("#look-new-name").tryQuery().isPresent());
        robot.interact(() -> {
            robot.lookup("#look-new-name").<TextField>query().setText("first");
            robot.lookup("#look-keep").<Button>query().fire();
        });
        waitFor("the look is saved", () -> text("lesson-text").equals("Done."));
    }
}
