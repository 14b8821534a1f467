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
import lightning.base.work.Wait;
import lightning.editor.document.OpenDocument;
import lightning.editor.window.EditorDesk;
import lightning.editor.window.command.PathAsk;
import lightning.editor.window.widget.Looks;
import lightning.render.shading.ReferenceTracer;
import lightning.shot.movie.Ffmpeg;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;

class ShotExportPaneTest extends EditorDesk {
    private static final String SHOT = "shot { frames 1 5  light lamp { intensity { 1 0.5  5 2.5 } } }";
    private Stage window;
    private Path answered;

    static boolean hasFfmpeg() {
        return Ffmpeg.installed().isPresent();
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
                    new ShotExportPane(model().editor(), model().files(), model().picture().viewProperty(), new Answers()), 480, 320));
            Looks.dress(window.getScene());
            window.show();
        });
    }

    @AfterEach
    void closeExport() {
        robot.interact(window::close);
    }

    private final class Answers implements PathAsk {
        @Override
        public Optional<Path> fileToOpen(String title, String extension) {
            return Optional.empty();
        }

        @Override
        public Optional<Path> fileToSave(String title, String name, String extension) {
            return Optional.ofNullable(answered);
        }

        @Override
        public Optional<Path> folder(String title) {
            return Optional.ofNullable(answered);
        }
    }

    private void choose(ShotKind kind) {
        robot.interact(() -> robot.lookup("#shot-kind").<ChoiceBox<ShotKind>>query().setValue(kind));
    }

    private void begin(String told) {
        click("shot-begin");
        waitFor("it is told: " + told, () -> text("shot-status").startsWith(told));
    }

    private void type(String field, String text) {
        robot.clickOn("#" + field);
        robot.interact(() -> robot.lookup("#" + field).<TextField>query().setText(text));
        robot.push(KeyCode.ENTER);
    }

    @Test
    void pictures_areThoseOfTheirFrames() throws Exception {
        answered = folder.resolve("out");
        type("shot-first", "2");
        begin("Exported 4 frames");
        for (int frame = 2; frame <= 5; frame++) {
            var image = ImageIO.read(answered.resolve("desk-000" + frame + ".png").toFile());
            int[] expected = model().picture().viewProperty().get()
                    .toPixels(new ReferenceTracer(model().editor().document().content().at(frame)).trace());
            assertThat(image.getRGB(0, 0, 64, 48, null, 0, 64)).as("frame " + frame).isEqualTo(expected);
        }
        assertThat(answered.resolve("desk-0001.png")).doesNotExist();
    }

    @Test
    @EnabledIf("hasFfmpeg")
    void film_hasTheFrames() throws Exception {
        waitFor("ffmpeg is found", () -> {
            robot.lookup("#shot-kind").<ChoiceBox<ShotKind>>query().setValue(ShotKind.MP4);
            return !robot.lookup("#shot-begin").query().isDisabled();
        });
        answered = folder.resolve("out/a.mp4");
        begin("Exported 5 frames");
        Process probe = new ProcessBuilder("ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=width,height,nb_read_frames",
                "-of", "csv=p=0", answered.toString()).start();
        assertThat(new String(probe.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip()).isEqualTo("64,48,5");
    }

    @Test
    void cancelledExport_leavesWhatIsFinished() throws Exception {
        answered = folder.resolve("out");
        type("shot-last", "5000");
        begin("Exporting");
        waitFor("some are there", () -> Files.exists(answered.resolve("desk-0003.png")));
        click("shot-cancel");
        waitFor("it ended", () -> text("shot-status").startsWith("Cancelled; "));
        assertThat(text("shot-status")).endsWith(" of 5000 pictures are written");
        Wait.untilEnded("lightning-shot-export");
    }

    @Test
    void framesInTheWrongOrder_areNotExported() {
        type("shot-last", "3");
        type("shot-first", "4");
        assertThat(robot.lookup("#shot-begin").query().isDisabled()).isTrue();
    }
}
