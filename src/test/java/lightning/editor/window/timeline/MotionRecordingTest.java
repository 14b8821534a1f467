package lightning.editor.window.timeline;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.scene.layout.Pane;
import javafx.stage.Stage;
import lightning.base.math.Vec3;
import lightning.document.EditOutcome;
import lightning.document.OpenDocument;
import lightning.editor.Command;
import lightning.editor.window.JavaFxRequirement;
import lightning.editor.window.StageExtension;
import lightning.editor.window.TestEditors;
import lightning.editor.window.command.PathPrompt;
import lightning.editor.window.model.EditorModel;
import lightning.sample.Slow;
import lightning.scene.SceneElement;
import lightning.scene.light.Light;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.KeyframeValue;
import lightning.scene.shot.Track;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import org.testfx.framework.junit5.Stop;

/** Records in a model without a preview, whose frames the tests simulate. */
@ExtendWith({JavaFxRequirement.class, StageExtension.class})
@Slow
class MotionRecordingTest {
    private static final String SHOT = """
            shot {
              frames 1 21
              light key {
                at { 1 0 2 0  11 1 2 0  21 1 3 0 }
                direction { 1 0 -1 0  11 0 -1 0  21 1 -1 0 }
              }
            }
            """;

    @TempDir
    private Path folder;
    private EditorModel model;
    private MotionRecording recording;

    /** Answers every file dialog with the same path. */
    private record Answer(Path file) implements PathPrompt {
        @Override
        public Optional<Path> fileToOpen(String title, String extension) {
            return Optional.of(file);
        }

        @Override
        public Optional<Path> fileToSave(String title, String name, String extension) {
            return Optional.of(file);
        }

        @Override
        public Optional<Path> folder(String title) {
            return Optional.empty();
        }
    }

    @Start
    private void start(Stage stage) throws Exception {
        model = TestEditors.model(folder);
        TestEditors.show(stage, new Pane());
        recording = new MotionRecording(model, () -> new Answer(path()));
        model.editor().selection().selectLight("key");
    }

    @Stop
    private void stop() {
        model.close();
    }

    private Path path() {
        return folder.resolve("key.path");
    }

    private void open(FxRobot robot, String shot) throws Exception {
        var file = folder.resolve("desk.jen");
        Files.writeString(file, Files.readString(file) + shot);
        OpenDocument opened = OpenDocument.open(file);
        robot.interact(() -> {
            model.open(opened);
            model.editor().selection().selectLight("key");
        });
    }

    private void run(FxRobot robot, Command command) {
        robot.interact(() -> model.commands().run(command));
    }

    private String message() {
        return model.editor().message().textProperty().get();
    }

    private List<Keyframe> keys(String attribute) {
        return model.editor().document().content().shot().flatMap(shot -> shot.track(new SceneElement.OfLight("key"), attribute))
                .map(Track::keys)
                .orElse(List.of());
    }

    private double x() {
        return TestEditors.light(model, "key").position().x();
    }

    /** Simulates preview frames, with the light one unit further along x in each. */
    private void move(FxRobot robot, int frames) {
        for (int i = 0; i < frames; i++) {
            robot.interact(() -> {
                Light key = TestEditors.light(model, "key");
                model.editor().edit(s -> new EditOutcome.Applied(s.withLight(key.withPosition(key.position().plus(new Vec3(1, 0, 0))))));
                model.previewSettings().framesProperty().set(model.previewSettings().framesProperty().get() + 1);
            });
        }
    }

    @Test
    void movementWhileRecording_becomesKeyframes(FxRobot robot) {
        double x = x();
        robot.interact(() -> recording.intervalProperty().set(2));
        run(robot, Command.MAKE_ANIMATION);
        move(robot, 4);
        assertThat(recording.statusProperty().get()).isEqualTo("Recording key: 5 frames");
        run(robot, Command.MAKE_ANIMATION);
        assertThat(recording.statusProperty().get()).isEmpty();
        int first = keys("at").getFirst().frame();
        assertThat(keys("at").stream().map(key -> key.frame() - first)).containsExactly(0, 2, 4);
        assertThat(keys("at").stream().map(key -> ((KeyframeValue.Numbers) key.value()).values().getFirst() - x)).containsExactly(0.0, 2.0,
                4.0);
        assertThat(message()).isEqualTo("3 keyframes over 5 frames");
        assertThat(model.layout().timelineShownProperty().get()).isTrue();
        run(robot, Command.UNDO);
        assertThat(model.editor().document().content().shot()).isEmpty();
        assertThat(x()).isEqualTo(x + 4);
    }

    @Test
    void interval_isTenAtFirst() {
        assertThat(recording.intervalProperty().get()).isEqualTo(10);
    }

    @Test
    void otherSelection_endsRecording(FxRobot robot) {
        run(robot, Command.MAKE_ANIMATION);
        move(robot, 1);
        robot.interact(() -> model.editor().selection().selectLight("fill"));
        assertThat(model.commands().toggleState(Command.MAKE_ANIMATION).orElseThrow().getValue()).isFalse();
        assertThat(keys("at")).hasSize(1);
    }

    @Test
    void otherDocument_dropsWhatIsRecorded(FxRobot robot) throws Exception {
        run(robot, Command.MAKE_ANIMATION);
        move(robot, 1);
        open(robot, "");
        assertThat(model.commands().toggleState(Command.MAKE_ANIMATION).orElseThrow().getValue()).isFalse();
        assertThat(model.editor().document().content().shot()).isEmpty();
    }

    @Test
    void keys_savedAsPathAndOpened_moveToOtherFrame(FxRobot robot) throws Exception {
        open(robot, SHOT);
        robot.interact(() -> model.editor().showFrame(5));
        List<Keyframe> before = keys("at");
        run(robot, Command.KEYS_TO_WAY);
        TestEditors.await(() -> message().startsWith("Saved to "));
        run(robot, Command.WAY_TO_KEYS);
        TestEditors.await(() -> message().equals("3 keyframes over 21 frames"));
        Stream.of("at", "direction").forEach(a -> assertThat(keys(a).stream().map(Keyframe::frame)).containsExactly(5, 15, 25));
        assertThat(keys("at").stream().map(Keyframe::value).toList()).isEqualTo(before.stream().map(Keyframe::value).toList());
        assertThat(model.editor().document().shotFrame().orElseThrow().shot().last()).isEqualTo(25);
        run(robot, Command.UNDO);
        assertThat(keys("at")).isEqualTo(before);
    }

    @Test
    void unevenKeys_areNoPath(FxRobot robot) throws Exception {
        open(robot, SHOT.replace("11 1 2 0", "12 1 2 0"));
        run(robot, Command.KEYS_TO_WAY);
        assertThat(message()).startsWith("Expected linear keyframes of position and direction");
        assertThat(path()).doesNotExist();
    }

    @Test
    void invalidPathFile_changesNothing(FxRobot robot) throws Exception {
        open(robot, SHOT);
        List<Keyframe> before = keys("at");
        Files.writeString(path(), "lightning-path 1\nat 1 2\n");
        run(robot, Command.WAY_TO_KEYS);
        TestEditors.await(() -> message().startsWith("Not opened: "));
        assertThat(message()).contains("key.path:2");
        assertThat(keys("at")).isEqualTo(before);
    }
}
