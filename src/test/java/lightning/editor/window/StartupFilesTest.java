package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import javafx.scene.control.Button;
import javafx.stage.Stage;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import org.testfx.framework.junit5.Stop;

@ExtendWith({JavaFxRequirement.class, StageExtension.class})
@Slow
class StartupFilesTest {
    @TempDir
    private Path folder;
    private LightningApp app;
    private volatile Editor editor;

    @Start
    private void start(Stage stage) throws Exception {
        Path mesh = Files.writeString(folder.resolve("tri.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        app = new LightningApp() {
            @Override
            Path file() {
                return mesh;
            }

            @Override
            void editorOpened(Editor opened) {
                editor = opened;
            }
        };
        app.init();
        app.start(stage);
    }

    @Stop
    private void stop() {
        app.stop();
    }

    @Test
    void foreignFile_createsSceneNextToIt(FxRobot robot) throws Exception {
        TestEditors.awaitNode(robot, "#lighting-studio");
        robot.interact(() -> robot.lookup("#lighting-studio").<Button>query().fire());
        TestEditors.await(() -> editor != null && editor.model().editor().document().name().equals("tri.jen"));
        assertThat(folder.resolve("tri.jen")).exists();
    }
}
