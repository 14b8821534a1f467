package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.LongPredicate;
import javafx.scene.layout.Pane;
import javafx.stage.Stage;
import lightning.base.math.Vec3;
import lightning.document.EditOutcome;
import lightning.editor.window.JavaFxRequirement;
import lightning.editor.window.StageExtension;
import lightning.editor.window.TestEditors;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import org.testfx.framework.junit5.Stop;

@ExtendWith({JavaFxRequirement.class, StageExtension.class})
class FramePlayerTest {
    @TempDir
    private Path folder;
    private EditorModel model;
    /** Shown frame, and the traced picture's frame when the next one was requested. */
    private final List<Scene> shown = new ArrayList<>();
    private final List<Scene> traced = new ArrayList<>();
    private volatile int requestCount;
    private volatile boolean isFinished;

    @Start
    private void start(Stage stage) throws Exception {
        model = TestEditors.model(folder);
        TestEditors.show(stage, new Pane());
        model.editor().liveProperty().set(true);
    }

    @Stop
    private void stop() {
        model.close();
    }

    private FramePlayer play(FxRobot robot, LongPredicate next) {
        var player = new FramePlayer(model.editor(), model.picture(), () -> isFinished, next);
        robot.interact(player::play);
        return player;
    }

    private boolean showNext() {
        traced.add(model.picture().frame().scene());
        Light key = TestEditors.light(model, "key");
        model.editor().edit(s -> new EditOutcome.Applied(s.withLight(key.withPosition(key.position().plus(new Vec3(1, 0, 0))))));
        shown.add(model.editor().scene());
        requestCount++;
        return true;
    }

    @Test
    void nextFrame_isShownWhenLastPictureIsFinished(FxRobot robot) throws Exception {
        Scene first = model.editor().scene();
        FramePlayer player = play(robot, _ -> showNext());
        TestEditors.await(() -> requestCount > 3);
        robot.interact(player::stop);
        assertThat(traced.getFirst()).isEqualTo(first);
        assertThat(traced.subList(1, traced.size())).isEqualTo(shown.subList(0, shown.size() - 1));
        assertThat(player.isPlaying()).isFalse();
        int stopped = requestCount;
        TestEditors.await(() -> model.picture().frame().scene().equals(shown.getLast()));
        assertThat(requestCount).isEqualTo(stopped);
    }

    @Test
    void noFrameDue_isRequestedAgainUntilEnd(FxRobot robot) throws Exception {
        FramePlayer player = play(robot, _ -> {
            requestCount++;
            return false;
        });
        TestEditors.await(() -> requestCount > 3);
        isFinished = true;
        TestEditors.await(() -> !player.isPlaying());
        int stopped = requestCount;
        isFinished = false;
        robot.interact(() -> {});
        assertThat(requestCount).isEqualTo(stopped);
    }
}
