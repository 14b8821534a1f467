package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.LongPredicate;
import javafx.scene.layout.Pane;
import javafx.stage.Stage;
import lightning.base.math.Vec3;
import lightning.editor.window.JavaFxNeeds;
import lightning.editor.window.OnStage;
import lightning.editor.window.OpenEditor;
import lightning.scene.Light;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import org.testfx.framework.junit5.Stop;

@ExtendWith({JavaFxNeeds.class, OnStage.class})
class FramePlayerTest {
    @TempDir
    private Path folder;
    private EditorModel model;
    /** What was shown, and what the traced picture showed when the next frame was asked for. */
    private final List<Scene> shown = new ArrayList<>();
    private final List<Scene> traced = new ArrayList<>();
    private volatile int asked;
    private volatile boolean ends;

    @Start
    private void start(Stage stage) throws Exception {
        model = OpenEditor.model(folder);
        OpenEditor.show(stage, new Pane());
        model.editor().beginAnimation();
    }

    @Stop
    private void stop() {
        model.close();
    }

    private FramePlayer play(FxRobot robot, LongPredicate next) {
        var player = new FramePlayer(model.editor(), model.picture(), () -> ends, next);
        robot.interact(player::play);
        return player;
    }

    private boolean showNext() {
        traced.add(model.picture().frame().scene());
        Light key = OpenEditor.light(model, "key");
        model.editor().animate(model.editor().scene().withLight(key.withPosition(key.position().plus(new Vec3(1, 0, 0)))));
        shown.add(model.editor().scene());
        asked++;
        return true;
    }

    @Test
    void nextFrame_isShownWhenThePictureOfTheLastIsFinished(FxRobot robot) throws Exception {
        Scene first = model.editor().scene();
        FramePlayer player = play(robot, _ -> showNext());
        OpenEditor.await(() -> asked > 3);
        robot.interact(player::stop);
        assertThat(traced.getFirst()).isEqualTo(first);
        assertThat(traced.subList(1, traced.size())).isEqualTo(shown.subList(0, shown.size() - 1));
        assertThat(player.isPlaying()).isFalse();
        int stopped = asked;
        OpenEditor.await(() -> model.picture().frame().scene().equals(shown.getLast()));
        assertThat(asked).isEqualTo(stopped);
    }

    @Test
    void whereNoFrameIsDue_itIsAskedAgainUntilItEnds(FxRobot robot) throws Exception {
        FramePlayer player = play(robot, _ -> {
            asked++;
            return false;
        });
        OpenEditor.await(() -> asked > 3);
        ends = true;
        OpenEditor.await(() -> !player.isPlaying());
        int stopped = asked;
        ends = false;
        robot.interact(() -> {});
        assertThat(asked).isEqualTo(stopped);
    }
}
