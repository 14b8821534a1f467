package lightning.editor.window.timeline;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import javafx.scene.Scene;
import javafx.scene.control.TextField;
import javafx.stage.Stage;
import lightning.document.OpenDocument;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.command.PathPrompt;
import lightning.editor.window.widget.ColorTheme;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class MachinesPaneTest extends EditorFixture {
    private Stage window;
    private Path pathAnswer;

    @BeforeEach
    void openPane() throws Exception {
        var file = folder.resolve("desk.jen");
        Files.writeString(file, Files.readString(file) + "shot { frames 1 2 }");
        OpenDocument opened = OpenDocument.open(file);
        robot.interact(() -> {
            model().open(opened);
            window = new Stage();
            window.setScene(
                    new Scene(new MachinesPane(model().editor(), model().files(), model().renderMachines(), new PathAnswers()), 480, 250));
            ColorTheme.style(window.getScene());
            window.show();
        });
    }

    @AfterEach
    void closePane() {
        robot.interact(window::close);
    }

    private final class PathAnswers implements PathPrompt {
        @Override
        public Optional<Path> fileToOpen(String title, String extension) {
            assertThat(extension).isEqualTo("p12");
            return Optional.ofNullable(pathAnswer);
        }

        @Override
        public Optional<Path> fileToSave(String title, String name, String extension) {
            return Optional.empty();
        }

        @Override
        public Optional<Path> folder(String title) {
            return Optional.empty();
        }
    }

    private TextField field(String id) {
        return robot.lookup("#" + id).query();
    }

    @Test
    void browse_setsCertificate_unlessCanceled() {
        pathAnswer = folder.resolve("shared.p12");
        click("machines-browse");
        assertThat(field("machines-certificate").getText()).isEqualTo(pathAnswer.toString());
        pathAnswer = null;
        click("machines-browse");
        assertThat(field("machines-certificate").getText()).isEqualTo(folder.resolve("shared.p12").toString());
    }

    @Test
    void missingCertificate_showsMessageAndFocusesField() {
        robot.interact(() -> field("machines-hosts").setText("render7"));
        click("machines-begin");
        assertThat(text("machines-status")).startsWith("Choose the render nodes' shared certificate");
        assertThat(field("machines-certificate").isFocused()).isTrue();
    }

    @Test
    void unknownMachine_showsMessage() {
        robot.interact(() -> {
            field("machines-hosts").setText("no-such-machine.invalid");
            field("machines-certificate").setText("c.p12");
        });
        click("machines-begin");
        waitFor("the error is shown", () -> text("machines-status").startsWith("unknown host 'no-such-machine.invalid'"));
    }
}
