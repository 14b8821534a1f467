package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import javafx.scene.control.DialogPane;
import javafx.scene.input.KeyCode;
import lightning.editor.Command;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.testfx.util.WaitForAsyncUtils;

/** Opening a path that is not a regular file keeps the open scene and blocks no thread. */
@EnabledOnOs(OS.LINUX)
class SpecialFilesTest extends EditorFixture {
    private void assertRefused(Path path, String message) {
        Path before = model().editor().document().file();
        answer = path;
        WaitForAsyncUtils.asyncFx(() -> model().commands().run(Command.LOAD_FILE));
        waitFor("the refusal is shown", () -> robot.lookup(".dialog-pane").tryQuery().isPresent());
        assertThat(robot.lookup(".dialog-pane").<DialogPane>query().getContent().toString()).contains(message);
        robot.type(KeyCode.ESCAPE);
        waitFor("the refusal is gone", () -> robot.lookup(".dialog-pane").tryQuery().isEmpty());
        assertThat(model().editor().document().file()).isEqualTo(before);
    }

    @Test
    void pipe_isRefusedImmediately() throws Exception {
        Path pipe = folder.resolve("pipe.jen");
        assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor()).isZero();
        assertRefused(pipe, "is a pipe or a device, expected a .jen file");
    }

    @Test
    void folder_isRefused() throws Exception {
        assertRefused(Files.createDirectory(folder.resolve("folder.jen")), "is a folder, expected a .jen file");
    }

    @Test
    void device_isRefusedImmediately() {
        assertRefused(Path.of("/dev/zero"), "/dev/zero: is a pipe or a device, expected a .jen file");
    }
}
