package lightning.editor.window.traced;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javafx.application.Platform;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.stage.Stage;
import lightning.base.work.Await;
import lightning.document.FileThread;
import lightning.document.OpenDocument;
import lightning.document.RecoveryFolder;
import lightning.editor.window.JavaFxRequirement;
import lightning.editor.window.StageExtension;
import lightning.editor.window.TestEditors;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.widget.ManualScheduler;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import org.testfx.framework.junit5.Stop;

/** Note on a first, incomplete picture: it appears immediately, so no delayed update runs in this test. */
@ExtendWith({JavaFxRequirement.class, StageExtension.class})
@Slow
class CoarseNoteTest {
    @TempDir
    private Path folder;

    private Stage stage;
    private EditorModel model;
    private TracedPane pane;

    @Start
    void start(Stage primary) {
        stage = primary;
    }

    @Stop
    void stop() {
        pane.close();
        model.close();
    }

    private void open(FxRobot robot, String picture, Runnable action) throws Exception {
        Path file = Files.writeString(folder.resolve("scene.jen"), "jen 1\npicture { " + picture + " }\nsphere ball { }\n");
        OpenDocument document = OpenDocument.open(file);
        robot.interact(() -> {
            model = new EditorModel(document, new RecoveryFolder(folder.resolve("recovery")), new FileThread(Platform::runLater));
            pane = new TracedPane(model, new ManualScheduler());
            TestEditors.show(stage, pane);
            action.run();
        });
    }

    private static String noteText(FxRobot robot) {
        Node badge = robot.lookup("#pending").query();
        return badge.isVisible() ? ((Label) badge).getText() : "";
    }

    @Test
    void coarsePicture_showsNoteImmediately(FxRobot robot) throws Exception {
        open(robot, "size 6000 4000", () -> {});
        TestEditors.await(() -> !pane.isEmpty());
        assertThat(model.picture().frame()).isNull();
        assertThat(noteText(robot)).isEqualTo("Refining…");
    }

    /** Many edges, whose samples take seconds: the window shows the centers while the samples are rendered. */
    @Test
    void centerSamples_announceFinerSamplesImmediately(FxRobot robot) throws Exception {
        var spheres = new StringBuilder("size 1500 1000  antialias edges  samples 8 }");
        for (int i = 0; i < 400; i++) {
            spheres.append("\nsphere s").append(i).append(" { at ").append(i % 20 / 10.0 - 1).append(' ').append(i / 20 / 10.0 - 1)
                    .append(" 0  scale 0.04 0.04 0.04 }");
        }
        var words = new CompletableFuture<String>();
        open(robot, spheres + "\nworld {", () -> model.picture().renderStateProperty().subscribe(now -> {
            if (now.frame() != null && !words.isDone()) {
                // After all listeners were called.
                Platform.runLater(
                        () -> words.complete((model.picture().frame().isFinished() ? "finished: " : "centers: ") + noteText(robot)));
            }
        }));
        assertThat(words.get(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS)).isEqualTo("centers: Anti-aliasing…");
    }
}
