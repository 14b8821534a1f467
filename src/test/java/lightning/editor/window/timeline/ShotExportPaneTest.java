package lightning.editor.window.timeline;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import javafx.scene.Scene;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.stage.Stage;
import javax.imageio.ImageIO;
import lightning.base.work.Await;
import lightning.document.OpenDocument;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.command.PathPrompt;
import lightning.editor.window.widget.ColorTheme;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.shot.movie.Ffmpeg;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;

class ShotExportPaneTest extends EditorFixture {
    private static final String SHOT = "shot { frames 1 5  light lamp { intensity { 1 0.5  5 2.5 } } }";
    private Stage window;
    private Path pathAnswer;

    static boolean hasFfmpeg() {
        return Ffmpeg.find().isPresent();
    }

    @BeforeEach
    void openExport() throws Exception {
        var file = folder.resolve("desk.jen");
        Files.writeString(file, Files.readString(file) + SHOT);
        OpenDocument opened = OpenDocument.open(file);
        Files.createDirectory(folder.resolve("out"));
        robot.interact(() -> {
            model().open(opened);
            window = new Stage();
            window.setScene(new Scene(
                    new ShotExportPane(model().editor(), model().files(), model().picture().viewProperty(), new PathAnswers()), 480, 320));
            ColorTheme.style(window.getScene());
            window.show();
        });
    }

    @AfterEach
    void closeExport() {
        robot.interact(window::close);
    }

    private final class PathAnswers implements PathPrompt {
        @Override
        public Optional<Path> fileToOpen(String title, String extension) {
            return Optional.empty();
        }

        @Override
        public Optional<Path> fileToSave(String title, String name, String extension) {
            return Optional.ofNullable(pathAnswer);
        }

        @Override
        public Optional<Path> folder(String title) {
            return Optional.ofNullable(pathAnswer);
        }
    }

    private void choose(ShotFormat kind) {
        robot.interact(() -> robot.lookup("#shot-kind").<ChoiceBox<ShotFormat>>query().setValue(kind));
    }

    private void begin(String status) {
        click("shot-begin");
        waitFor("the status is shown: " + status, () -> text("shot-status").startsWith(status));
    }

    private void type(String field, String text) {
        robot.clickOn("#" + field);
        robot.interact(() -> robot.lookup("#" + field).<TextField>query().setText(text));
        robot.push(KeyCode.ENTER);
    }

    @Test
    void pictures_matchTheirFrames() throws Exception {
        pathAnswer = folder.resolve("out");
        type("shot-first", "2");
        begin("Exported 4 frames");
        for (int frame = 2; frame <= 5; frame++) {
            var image = ImageIO.read(pathAnswer.resolve("desk-000" + frame + ".png").toFile());
            int[] expected = model().picture().viewProperty().get()
                    .toPixels(new ReferenceTracer(model().editor().document().content().sceneAt(frame)).trace());
            assertThat(image.getRGB(0, 0, 64, 48, null, 0, 64)).as("frame " + frame).isEqualTo(expected);
        }
        assertThat(pathAnswer.resolve("desk-0001.png")).doesNotExist();
    }

    @Test
    @EnabledIf("hasFfmpeg")
    void movie_hasFrames() throws Exception {
        waitFor("ffmpeg is found", () -> {
            robot.lookup("#shot-kind").<ChoiceBox<ShotFormat>>query().setValue(ShotFormat.MP4);
            return !robot.lookup("#shot-begin").query().isDisabled();
        });
        pathAnswer = folder.resolve("out/a.mp4");
        begin("Exported 5 frames");
        Process probe = new ProcessBuilder("ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=width,height,nb_read_frames",
                "-of", "csv=p=0", pathAnswer.toString()).start();
        assertThat(new String(probe.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip()).isEqualTo("64,48,5");
    }

    @Test
    void canceledExport_keepsFinishedPictures() throws Exception {
        pathAnswer = folder.resolve("out");
        type("shot-last", "5000");
        begin("Exporting");
        waitFor("the third frame is written", () -> Files.exists(pathAnswer.resolve("desk-0003.png")));
        click("shot-cancel");
        waitFor("the export is canceled", () -> text("shot-status").startsWith("Canceled; "));
        assertThat(text("shot-status")).endsWith(" of 5000 images saved");
        Await.untilThreadEnded("lightning-shot-export");
    }

    @Test
    void firstFrameAfterLast_isNotExported() {
        type("shot-last", "3");
        type("shot-first", "4");
        assertThat(robot.lookup("#shot-begin").query().isDisabled()).isTrue();
    }
}
