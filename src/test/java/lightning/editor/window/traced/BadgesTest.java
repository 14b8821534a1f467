package lightning.editor.window.traced;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.stage.Stage;
import javafx.util.Duration;
import lightning.editor.document.Change;
import lightning.editor.document.Command;
import lightning.editor.document.Desk;
import lightning.editor.window.JavaFxNeeds;
import lightning.editor.window.OnStage;
import lightning.editor.window.OpenEditor;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.widget.HandTime;
import lightning.sample.Slow;
import lightning.scene.Antialias;
import lightning.scene.Sampling;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import org.testfx.framework.junit5.Stop;

/** The canvas's badges, in time that passes by hand. */
@ExtendWith({JavaFxNeeds.class, OnStage.class})
@Slow
class BadgesTest {
    @TempDir
    private Path folder;

    private final HandTime time = new HandTime();
    private EditorModel model;
    private TracedPane pane;

    @Start
    void start(Stage stage) throws Exception {
        model = OpenEditor.model(folder);
        pane = new TracedPane(model, time);
        OpenEditor.show(stage, pane);
    }

    @Stop
    void stop() {
        pane.close();
        model.close();
    }

    private boolean isShown(FxRobot robot, String badge) {
        return robot.lookup("#" + badge).<Node>query().isVisible();
    }

    private void dim(FxRobot robot, double intensity) {
        robot.interact(() -> model.editor().edit(scene -> Desk.dial("intensity").set(scene, OpenEditor.POINT, intensity)));
    }

    @Test
    void liveUpdates_letNoBadgeFlash(FxRobot robot) throws Exception {
        OpenEditor.await(() -> model.picture().frame() != null);
        robot.interact(() -> model.editor().liveProperty().set(true));
        for (int i = 0; i < 5; i++) {
            dim(robot, 0.1 * i);
            robot.interact(() -> time.pass(Duration.millis(60)));
            assertThat(isShown(robot, "pending")).isFalse();
            OpenEditor.await(() -> !model.editor().situationProperty().get().isPending());
            robot.interact(() -> time.pass(Duration.millis(60)));
            assertThat(isShown(robot, "pending")).isFalse();
        }
    }

    @Test
    void editsThatWaitForGo_areToldOfInATenthOfASecond(FxRobot robot) throws Exception {
        OpenEditor.await(() -> model.picture().frame() != null);
        dim(robot, 2);
        assertThat(isShown(robot, "pending")).isFalse();
        robot.interact(() -> time.pass(Duration.millis(100)));
        assertThat(isShown(robot, "pending")).isTrue();
        robot.interact(() -> model.workbench().undo());
        assertThat(isShown(robot, "pending")).isFalse();
    }

    @Test
    void samplesThatWereCancelled_areToldOfUntilGo(FxRobot robot) throws Exception {
        OpenEditor.await(() -> model.picture().frame() != null);
        var sampling = new Sampling(Antialias.EDGES, 8);
        robot.interact(() -> model.editor().edit(scene -> Change
                .of(() -> scene.withPicture(scene.picture().withSize(400, 300).withSampling(sampling)))));
        robot.interact(() -> model.picture().renderingProperty().subscribe(state -> {
            if (state.frame() != null && !state.frame().finished()) {
                model.workbench().cancel();
            }
        }));
        robot.interact(() -> model.commands().run(Command.GO));
        OpenEditor.await(() -> !model.picture().frame().finished() && model.editor().situationProperty().get().inWork().isEmpty());
        robot.interact(() -> time.pass(Duration.millis(100)));
        assertThat(isShown(robot, "pending")).isTrue();
        assertThat(robot.lookup("#pending").<Label>query().getText()).isEqualTo("Without finer samples");
    }
}
