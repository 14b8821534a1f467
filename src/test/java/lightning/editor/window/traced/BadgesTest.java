package lightning.editor.window.traced;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.stage.Stage;
import javafx.util.Duration;
import lightning.document.DeskScene;
import lightning.document.EditOutcome;
import lightning.editor.Command;
import lightning.editor.window.JavaFxRequirement;
import lightning.editor.window.StageExtension;
import lightning.editor.window.TestEditors;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.widget.ManualScheduler;
import lightning.sample.Slow;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import org.testfx.framework.junit5.Stop;

/** Badges over the picture, with a manual clock. */
@ExtendWith({JavaFxRequirement.class, StageExtension.class})
@Slow
class BadgesTest {
    @TempDir
    private Path folder;

    private final ManualScheduler scheduler = new ManualScheduler();
    private EditorModel model;
    private TracedPane pane;

    @Start
    void start(Stage stage) throws Exception {
        model = TestEditors.model(folder);
        pane = new TracedPane(model, scheduler);
        TestEditors.show(stage, pane);
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
        robot.interact(() -> model.editor().edit(scene -> DeskScene.parameter("intensity").set(scene, TestEditors.POINT, intensity)));
    }

    @Test
    void liveUpdates_showNoBadge(FxRobot robot) throws Exception {
        TestEditors.await(() -> model.picture().frame() != null);
        robot.interact(() -> model.editor().liveProperty().set(true));
        for (int i = 0; i < 5; i++) {
            dim(robot, 0.1 * i);
            robot.interact(() -> scheduler.advance(Duration.millis(60)));
            assertThat(isShown(robot, "pending")).isFalse();
            TestEditors.await(() -> !model.editor().editorStateProperty().get().hasPendingEdits());
            robot.interact(() -> scheduler.advance(Duration.millis(60)));
            assertThat(isShown(robot, "pending")).isFalse();
        }
    }

    @Test
    void pendingEdits_showBadgeAfterDelay(FxRobot robot) throws Exception {
        TestEditors.await(() -> model.picture().frame() != null);
        dim(robot, 2);
        assertThat(isShown(robot, "pending")).isFalse();
        robot.interact(() -> scheduler.advance(Duration.millis(100)));
        assertThat(isShown(robot, "pending")).isTrue();
        robot.interact(() -> model.workbench().undo());
        assertThat(isShown(robot, "pending")).isFalse();
    }

    @Test
    void canceledSamples_showBadgeUntilGo(FxRobot robot) throws Exception {
        TestEditors.await(() -> model.picture().frame() != null);
        var sampling = new SamplingSettings(AntialiasMode.EDGES, 8);
        robot.interact(() -> model.editor().edit(scene -> EditOutcome
                .of(() -> scene.withPicture(scene.picture().withSize(400, 300).withSampling(sampling)))));
        robot.interact(() -> model.picture().renderStateProperty().subscribe(state -> {
            if (state.frame() != null && !state.frame().isFinished()) {
                model.workbench().cancel();
            }
        }));
        robot.interact(() -> model.commands().run(Command.GO));
        TestEditors.await(
                () -> !model.picture().frame().isFinished() && model.editor().editorStateProperty().get().sceneInProgress().isEmpty());
        robot.interact(() -> scheduler.advance(Duration.millis(100)));
        assertThat(isShown(robot, "pending")).isTrue();
        assertThat(robot.lookup("#pending").<Label>query().getText()).isEqualTo("Not anti-aliased");
    }
}
