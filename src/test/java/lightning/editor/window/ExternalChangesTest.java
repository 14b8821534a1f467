package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFilePermissions;
import javafx.application.Platform;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;
import javafx.scene.input.KeyCode;
import lightning.document.DeskScene;
import lightning.document.OpenDocument;
import lightning.document.OpenSceneRegistry;
import lightning.document.TextDifference;
import lightning.editor.Command;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Other programs write the open scene's file. */
class ExternalChangesTest extends EditorFixture {
    private Path file;
    private String otherText;

    @BeforeEach
    void prepare() throws IOException {
        file = folder.resolve("desk.jen");
        otherText = Files.readString(file).replace("ambience 0.2", "ambience 0.7");
    }

    private void dim() {
        robot.interact(() -> model().editor().edit(scene -> DeskScene.parameter("intensity").set(scene, "lamp", 0.25)));
    }

    /** Saves over a change by another program, and waits for the confirmation dialog. */
    private void saveOverOtherText() throws IOException {
        dim();
        writeOtherText();
        Platform.runLater(() -> model().commands().run(Command.SAVE_SCENE));
        waitFor("the question is shown", () -> robot.lookup("desk.jen was changed by another program").tryQuery().isPresent());
    }

    private double savedIntensity(Path where) throws IOException, JenException {
        return JenReader.read(where).scene().light("lamp").orElseThrow().intensity();
    }

    /** Writes atomically: a half-written file would trigger one notice and the complete file another. */
    private void writeOtherText() throws IOException {
        Files.move(Files.writeString(folder.resolve("his"), otherText), file, StandardCopyOption.REPLACE_EXISTING);
    }

    private void awaitNotice() {
        waitFor("the message is shown", this::isNoticeShown);
        // The notice must be laid out before anything in it is clicked.
        FastRobot.settle();
    }

    private boolean isNoticeShown() {
        return isShown("disk-bar");
    }

    @Test
    void saveOverOtherText_showsBothAndCancelKeepsBoth() throws IOException {
        saveOverOtherText();
        var both = robot.lookup("#differences").<ListView<TextDifference.Row>>queryAll().iterator().next();
        assertThat(both.getItems().stream().filter(row -> !row.isSame())).hasSize(2)
                .anyMatch(row -> row.mine().contains("ambience 0.2") && row.theirs().contains("ambience 0.7"))
                .anyMatch(row -> row.mine().contains("intensity 0.25"));
        robot.clickOn("Cancel");
        assertThat(file).hasContent(otherText);
        assertThat(model().editor().document().isDirty()).isTrue();
    }

    @ParameterizedTest
    @EnumSource(names = {"ENTER", "ESCAPE"})
    void enterAndEscape_keepBothTexts(KeyCode key) throws IOException {
        saveOverOtherText();
        robot.type(key);
        waitFor("the question is answered", () -> !isShown("differences"));
        assertThat(file).hasContent(otherText);
        assertThat(model().editor().document().isDirty()).isTrue();
    }

    @Test
    void longLines_showTheirDifference() throws IOException, JenException {
        String lamp = "light lamp point { at -2 2.2 0.5  intensity 1 }";
        String longLamp =
                "light lamp point { color 1 0.9 0.8  attenuation 1 0.0000000000001 0.0000000000001  at -2 2.2 0.5  intensity 0.75 }";
        String notes = "# note\n".repeat(80);
        otherText = otherText.replace("jen 1\n", "jen 1\n" + notes).replace(lamp, longLamp);
        Files.writeString(file, otherText.replace("0.75", "0.5"));
        OpenDocument document = OpenDocument.open(file);
        robot.interact(() -> model().open(document));
        saveOverOtherText();
        assertThat(robot.lookup("#differences .difference").queryAllAs(Label.class)).extracting(Label::getText)
                .anyMatch(text -> text.contains("intensity 0.25")).anyMatch(text -> text.contains("intensity 0.75"));
        robot.clickOn("Cancel");
    }

    @Test
    void overwrite_writesOwnScene() throws IOException, JenException {
        saveOverOtherText();
        robot.clickOn("Overwrite");
        waitFor("the scene is saved", () -> !model().editor().document().isDirty());
        assertThat(savedIntensity(file)).isEqualTo(0.25);
        assertThat(file).content().contains("ambience 0.2");
    }

    @Test
    void saveAs_keepsBothFiles() throws IOException, JenException {
        answer = folder.resolve("mine.jen");
        saveOverOtherText();
        robot.clickOn("Save As…");
        waitFor("the scene is saved", () -> model().editor().document().name().equals("mine.jen"));
        assertThat(file).hasContent(otherText);
        assertThat(savedIntensity(answer)).isEqualTo(0.25);
    }

    @Test
    void loadingOtherText_canBeUndone() throws IOException {
        saveOverOtherText();
        robot.clickOn("Reload File");
        waitFor("the scene is reloaded", () -> model().editor().scene().world().ambience() == 0.7);
        assertThat(model().editor().document().isDirty()).isFalse();
        click("undo");
        assertThat(light("lamp").intensity()).isEqualTo(0.25);
    }

    @Test
    void externalChange_isReportedAndReloaded() throws IOException {
        assertThat(isNoticeShown()).isFalse();
        writeOtherText();
        awaitNotice();
        assertThat(text("disk-news")).isEqualTo("desk.jen was changed by another program.");
        click("disk-reload");
        waitFor("the scene is reloaded", () -> !isNoticeShown());
        assertThat(model().editor().scene().world().ambience()).isEqualTo(0.7);
        assertThat(isNoticeShown()).isFalse();
    }

    @Test
    void externalChange_canBeIgnored() throws IOException {
        writeOtherText();
        awaitNotice();
        click("disk-keep");
        assertThat(isNoticeShown()).isFalse();
        assertThat(isEnabled(Command.SAVE_SCENE)).isTrue();
        assertThat(model().editor().scene().world().ambience()).isEqualTo(0.2);
    }

    @Test
    void externalChange_canBeCompared() throws IOException {
        writeOtherText();
        awaitNotice();
        Platform.runLater(() -> robot.lookup("#disk-compare").<Button>query().fire());
        waitFor("the differences are shown", () -> robot.lookup("#differences").tryQuery().isPresent());
        robot.clickOn("Cancel");
        assertThat(file).hasContent(otherText);
    }

    @Test
    void deletedFile_isReportedAndCanBeSavedAgain() throws IOException {
        Files.delete(file);
        awaitNotice();
        assertThat(text("disk-news")).contains("was moved or deleted");
        click("save-scene");
        waitFor("the scene is saved", () -> !isNoticeShown());
        assertThat(file).exists();
        assertThat(isNoticeShown()).isFalse();
    }

    @Test
    void secondEditor_isReported() throws IOException {
        try (var other = new OpenSceneRegistry(EditorPaths.dataFolder().resolve("open"))) {
            other.register(file);
            awaitNotice();
            assertThat(text("disk-news")).contains("is also open in another window");
        }
        waitFor("the notice is closed", () -> !isNoticeShown());
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void readOnlyScene_isReplacedOnlyAfterConfirmation() throws Exception {
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("r--r--r--"));
        String before = Files.readString(file);
        dim();
        Platform.runLater(() -> model().commands().run(Command.SAVE_SCENE));
        waitFor("the question is shown", () -> robot.lookup("Replace the read-only file desk.jen?").tryQuery().isPresent());
        assertThat(file).hasContent(before);
        robot.clickOn("Replace");
        waitFor("the scene is saved", () -> !model().editor().document().isDirty());
        assertThat(savedIntensity(file)).isEqualTo(0.25);
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file))).isEqualTo("r--r--r--");
    }

    @Test
    void addedExtension_neverReplacesOtherScene() throws IOException {
        Path other = Files.writeString(folder.resolve("other.jen"), "other text");
        answer = folder.resolve("other");
        Platform.runLater(() -> model().commands().run(Command.SAVE_SCENE_AS));
        waitFor("the question is shown", () -> robot.lookup("Replace other.jen?").tryQuery().isPresent());
        robot.clickOn("Cancel");
        assertThat(other).hasContent("other text");
    }
}
