package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFilePermissions;
import javafx.application.Platform;
import javafx.scene.control.Button;
import javafx.scene.control.ListView;
import lightning.editor.document.Command;
import lightning.editor.document.Desk;
import lightning.editor.document.Presence;
import lightning.editor.document.TextDifference;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** The open scene's file is written by others while it is open here. */
class OutsideChangesTest extends EditorDesk {
    private Path file;
    private String his;

    @BeforeEach
    void prepare() throws IOException {
        file = folder.resolve("desk.jen");
        his = Files.readString(file).replace("ambience 0.2", "ambience 0.7");
    }

    private void dim() {
        robot.interact(() -> model().editor().edit(scene -> Desk.dial("intensity").set(scene, "lamp", 0.25)));
    }

    /** Begins to save over what another wrote just before, and waits for the question. */
    private void saveOverHis() throws IOException {
        dim();
        writeHis();
        Platform.runLater(() -> model().commands().run(Command.SAVE_SCENE));
        waitFor("it asks", () -> robot.lookup("desk.jen was changed by another program").tryQuery().isPresent());
    }

    private double savedIntensity(Path where) throws IOException, JenException {
        return JenReader.read(where).scene().light("lamp").orElseThrow().intensity();
    }

    /** At once: a half-written file would be news, and the whole one news again. */
    private void writeHis() throws IOException {
        Files.move(Files.writeString(folder.resolve("his"), his), file, StandardCopyOption.REPLACE_EXISTING);
    }

    private void awaitTold() {
        waitFor("it is told", this::isTold);
        // The line takes its place before anything in it is clicked on.
        QuickRobot.settle();
    }

    private boolean isTold() {
        return isShown("disk-bar");
    }

    @Test
    void saveOverAnothersText_showsBothAndCancelLosesNeither() throws IOException {
        saveOverHis();
        var both = robot.lookup("#differences").<ListView<TextDifference.Row>>queryAll().iterator().next();
        assertThat(both.getItems().stream().filter(row -> !row.isSame())).hasSize(2)
                .anyMatch(row -> row.mine().contains("ambience 0.2") && row.theirs().contains("ambience 0.7"))
                .anyMatch(row -> row.mine().contains("intensity 0.25"));
        robot.clickOn("Cancel");
        assertThat(file).hasContent(his);
        assertThat(model().editor().document().isDirty()).isTrue();
    }

    @Test
    void overwrite_writesMine() throws IOException, JenException {
        saveOverHis();
        robot.clickOn("Overwrite");
        waitFor("it is saved", () -> !model().editor().document().isDirty());
        assertThat(savedIntensity(file)).isEqualTo(0.25);
        assertThat(file).content().contains("ambience 0.2");
    }

    @Test
    void saveAsInstead_keepsBoth() throws IOException, JenException {
        answer = folder.resolve("mine.jen");
        saveOverHis();
        robot.clickOn("Save As…");
        waitFor("it is saved", () -> model().editor().document().name().equals("mine.jen"));
        assertThat(file).hasContent(his);
        assertThat(savedIntensity(answer)).isEqualTo(0.25);
    }

    @Test
    void takingTheFiles_canBeUndone() throws IOException {
        saveOverHis();
        robot.clickOn("Take the File's");
        waitFor("it is reloaded", () -> model().editor().scene().world().ambience() == 0.7);
        assertThat(model().editor().document().isDirty()).isFalse();
        click("undo");
        assertThat(light("lamp").intensity()).isEqualTo(0.25);
    }

    @Test
    void changeFromOutside_isToldAndReloaded() throws IOException {
        assertThat(isTold()).isFalse();
        writeHis();
        awaitTold();
        assertThat(text("disk-news")).isEqualTo("desk.jen was changed by another program.");
        click("disk-reload");
        waitFor("it is reloaded", () -> !isTold());
        assertThat(model().editor().scene().world().ambience()).isEqualTo(0.7);
        assertThat(isTold()).isFalse();
    }

    @Test
    void changeFromOutside_canBeKeptOut() throws IOException {
        writeHis();
        awaitTold();
        click("disk-keep");
        assertThat(isTold()).isFalse();
        assertThat(isEnabled(Command.SAVE_SCENE)).isTrue();
        assertThat(model().editor().scene().world().ambience()).isEqualTo(0.2);
    }

    @Test
    void changeFromOutside_canBeLookedAt() throws IOException {
        writeHis();
        awaitTold();
        Platform.runLater(() -> robot.lookup("#disk-compare").<Button>query().fire());
        waitFor("both are shown", () -> robot.lookup("#differences").tryQuery().isPresent());
        robot.clickOn("Cancel");
        assertThat(file).hasContent(his);
    }

    @Test
    void fileThatIsGone_isToldAndCanBeSavedAgain() throws IOException {
        Files.delete(file);
        awaitTold();
        assertThat(text("disk-news")).contains("is no longer where it was");
        click("save-scene");
        waitFor("it is saved", () -> !isTold());
        assertThat(file).exists();
        assertThat(isTold()).isFalse();
    }

    @Test
    void secondEditor_isTold() throws IOException {
        try (var other = new Presence(Folders.data().resolve("open"))) {
            other.open(file);
            awaitTold();
            assertThat(text("disk-news")).contains("is open in another editor");
        }
        waitFor("it is gone", () -> !isTold());
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void readOnlyScene_isReplacedOnlyWhenAskedFor() throws Exception {
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("r--r--r--"));
        String before = Files.readString(file);
        dim();
        Platform.runLater(() -> model().commands().run(Command.SAVE_SCENE));
        waitFor("it asks", () -> robot.lookup("Replace desk.jen, which is read-only?").tryQuery().isPresent());
        assertThat(file).hasContent(before);
        robot.clickOn("Replace");
        waitFor("it is saved", () -> !model().editor().document().isDirty());
        assertThat(savedIntensity(file)).isEqualTo(0.25);
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file))).isEqualTo("r--r--r--");
    }

    @Test
    void endingThatTheEditorAdds_doesNotReplaceAnotherScene() throws IOException {
        Path other = Files.writeString(folder.resolve("other.jen"), "somebody's");
        answer = folder.resolve("other");
        Platform.runLater(() -> model().commands().run(Command.SAVE_SCENE_AS));
        waitFor("it asks", () -> robot.lookup("Replace other.jen?").tryQuery().isPresent());
        robot.clickOn("Cancel");
        assertThat(other).hasContent("somebody's");
    }
}
