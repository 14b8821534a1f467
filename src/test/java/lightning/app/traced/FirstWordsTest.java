package lightning.app.traced;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import javafx.application.Platform;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.stage.Stage;
import lightning.app.JavaFxNeeds;
import lightning.app.OnStage;
import lightning.app.OpenEditor;
import lightning.app.model.EditorModel;
import lightning.app.widget.HandTime;
import lightning.edit.FileThread;
import lightning.edit.OpenDocument;
import lightning.edit.Recovery;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import org.testfx.framework.junit5.Stop;

/** What is said of a first picture while it is not the picture yet: at once, so that no time passes here. */
@ExtendWith({JavaFxNeeds.class, OnStage.class})
class FirstWordsTest {
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

    private void open(FxRobot robot, String picture) throws Exception {
        Path file = Files.writeString(folder.resolve("scene.jen"), "jen 1\npicture { " + picture + " }\nsphere ball { }\n");
        OpenDocument document = OpenDocument.open(file);
        robot.interact(() -> {
            model = new EditorModel(document, new Recovery(folder.resolve("recovery")), new FileThread(Platform::runLater));
            pane = new TracedPane(model, new HandTime());
            OpenEditor.show(stage, pane);
        });
    }

    private static String said(FxRobot robot) {
        Node badge = robot.lookup("#pending").query();
        return badge.isVisible() ? ((Label) badge).getText() : "";
    }

    @Test
    void coarsePicture_saysSoAtOnce(FxRobot robot) throws Exception {
        open(robot, "size 6000 4000");
        OpenEditor.await(() -> !pane.isEmpty());
        assertThat(model.frame()).isNull();
        assertThat(said(robot)).isEqualTo("Coarse picture, a finer one follows");
    }

    @Test
    void centresOfTheFirstPicture_sayThatSamplesFollowAtOnce(FxRobot robot) throws Exception {
        open(robot, "size 3000 2000  antialias edges  samples 8");
        OpenEditor.await(() -> model.frame() != null);
        assertThat(model.frame().finished()).isFalse();
        assertThat(said(robot)).isEqualTo("Finer samples follow");
    }
}
