package lightning.editor.window.animation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.Pane;
import javafx.stage.Stage;
import lightning.base.math.Vec3;
import lightning.base.work.Await;
import lightning.editor.document.Command;
import lightning.editor.document.EditOutcome;
import lightning.editor.document.motion.MotionPathFile;
import lightning.editor.document.motion.RecordedShot;
import lightning.editor.window.JavaFxRequirement;
import lightning.editor.window.StageExtension;
import lightning.editor.window.TestEditors;
import lightning.editor.window.command.PathPrompt;
import lightning.editor.window.model.EditorModel;
import lightning.sample.Slow;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import org.testfx.framework.junit5.Stop;

@ExtendWith({JavaFxRequirement.class, StageExtension.class})
@Slow
class AnimationWindowTest {
    @TempDir
    private Path folder;
    private EditorModel model;
    private AnimationWindow window;
    private Scene before;

    /** Answers every file dialog with the same path. */
    private record Answer(Path path) implements PathPrompt {
        @Override
        public Optional<Path> fileToOpen(String title, String extension) {
            return Optional.of(path.resolve("way.path"));
        }

        @Override
        public Optional<Path> fileToSave(String title, String name, String extension) {
            return Optional.of(path.resolve("way.path"));
        }

        @Override
        public Optional<Path> folder(String title) {
            return Optional.of(path);
        }
    }

    @Start
    private void start(Stage stage) throws Exception {
        model = TestEditors.model(folder);
        TestEditors.show(stage, new Pane());
        before = model.editor().scene();
        window = new AnimationWindow(model, stage, new Answer(folder));
        window.show();
    }

    @Stop
    private void stop() {
        window.close();
        model.close();
    }

    @Test
    void openWindow_disablesDocumentEdits() {
        assertThat(model.editor().isAnimating()).isTrue();
        assertThat(model.commands().isEnabled(Command.MAKE_ANIMATION)).isFalse();
        assertThat(model.commands().isEnabled(Command.DELETE_LIGHT)).isFalse();
    }

    @Test
    void withoutAPath_onlyRecordAndLoadAreEnabled(FxRobot robot) {
        assertThat(Stream.of("record", "stop", "play", "save-animation", "load-animation", "export", "cancel-export", "scrub")
                .filter(id -> !robot.lookup("#" + id).query().isDisabled())).containsExactly("record", "load-animation");
    }

    @Test
    void movingLight_whileRecording_recordsPath(FxRobot robot) throws Exception {
        type(robot, "resolution", "2");
        record(robot, 5);
        robot.clickOn("#save-animation");
        TestEditors.await(() -> status(robot).startsWith("Saved to "));
        RecordedShot recorded = MotionPathFile.load(folder.resolve("way.path"), "key");
        assertThat(recorded.interval()).isEqualTo(2);
        assertThat(recorded.keyCount()).isEqualTo(3);
        assertThat(Stream.of(0, 2, 4).map(frame -> x(recorded.shot().sceneAt(before, frame)))).containsExactly(3.0, 5.0, 7.0);
    }

    @Test
    void resolution_defaultsToTen(FxRobot robot) {
        assertThat(field(robot, "resolution").getText()).isEqualTo("10");
        type(robot, "resolution", "0");
        assertThat(robot.lookup("#resolution .refusal").queryAs(Label.class).getText())
                .isEqualTo("keyframe interval must be from 1 to 10000, was 0");
    }

    @Test
    void play_rendersFramesUntilStop(FxRobot robot) throws Exception {
        load(robot, 0, 8);
        robot.clickOn("#play");
        TestEditors.await(() -> model.picture().frame() != null && x(model.picture().frame().scene()) > 1);
        robot.clickOn("#stop");
        assertThat(robot.lookup("#play").query().isDisabled()).isFalse();
        assertThat(robot.lookup("#stop").query().isDisabled()).isTrue();
        assertThat(x(model.editor().scene())).isBetween(0.0, 8.0);
        assertThat(model.editor().document().scene()).isEqualTo(before);
    }

    @Test
    void fileDialogs_openInSceneFolder(FxRobot robot) {
        robot.interact(() -> {
            assertThat(PathPrompt.folderChooser("Export", folder).getInitialDirectory()).isEqualTo(folder.toFile());
            assertThat(PathPrompt.fileChooser("Save", "path", folder).getInitialDirectory()).isEqualTo(folder.toFile());
        });
    }

    @Test
    void scrub_showsTheFrame(FxRobot robot) throws Exception {
        load(robot, 0, 8);
        robot.interact(() -> robot.lookup("#scrub").queryAs(Slider.class).setValue(5));
        assertThat(x(model.editor().scene())).isEqualTo(5);
        TestEditors.await(() -> model.picture().frame() != null && x(model.picture().frame().scene()) == 5);
    }

    @Test
    void close_restoresSceneAndPicture(FxRobot robot) throws Exception {
        load(robot, 0, 8);
        TestEditors.await(() -> model.picture().frame() != null && x(model.picture().frame().scene()) == 0);
        robot.clickOn("#close-animation");
        assertThat(model.editor().isAnimating()).isFalse();
        assertThat(model.editor().scene()).isEqualTo(before);
        assertThat(model.commands().isEnabled(Command.UNDO)).isFalse();
        TestEditors.await(() -> model.picture().frame().scene().equals(before));
    }

    @Test
    void escape_closesTheWindow(FxRobot robot) {
        robot.push(KeyCode.ESCAPE);
        assertThat(window.isShowing()).isFalse();
        assertThat(model.editor().isAnimating()).isFalse();
    }

    @Test
    void invalidPathFile_showsErrorAndChangesNothing(FxRobot robot) throws Exception {
        Files.writeString(folder.resolve("way.path"), "lightning-path 1\nat 1 2\n");
        robot.clickOn("#load-animation");
        TestEditors.await(() -> status(robot).startsWith("Not opened: "));
        assertThat(status(robot)).contains("way.path:2");
        assertThat(robot.lookup("#play").query().isDisabled()).isTrue();
    }

    @Test
    void export_writesNumberedPictures(FxRobot robot) throws Exception {
        load(robot, 0, 8);
        type(robot, "pictures", "3");
        robot.clickOn("#export");
        TestEditors.await(() -> status(robot).startsWith("Exported 3 images"));
        try (var files = Files.list(folder)) {
            assertThat(files.map(file -> file.getFileName().toString()).filter(name -> name.endsWith(".png")))
                    .containsExactlyInAnyOrder("desk-key-0001.png", "desk-key-0002.png", "desk-key-0003.png");
        }
    }

    @Test
    void canceledExport_showsNumberOfPictures(FxRobot robot) throws Exception {
        load(robot, 0, 8);
        type(robot, "pictures", "100000");
        robot.clickOn("#export").clickOn("#cancel-export");
        TestEditors.await(() -> status(robot).startsWith("Export canceled after "));
        assertThat(robot.lookup("#export").query().isDisabled()).isFalse();
        // The export ends after the current image; the test's folder is deleted only then.
        Await.untilThreadEnded("lightning-export");
    }

    /** Simulates preview frames, with the light one unit further along x in each. */
    private void record(FxRobot robot, int frames) {
        robot.clickOn("#record");
        for (int i = 0; i < frames; i++) {
            robot.interact(() -> {
                model.editor().edit(scene -> new EditOutcome.Applied(moved(scene)));
                model.previewSettings().framesProperty().set(model.previewSettings().framesProperty().get() + 1);
            });
        }
        robot.clickOn("#stop");
    }

    private static Scene moved(Scene scene) {
        Light key = scene.light("key").orElseThrow();
        return scene.withLight(key.withPosition(key.position().plus(new Vec3(1, 0, 0))));
    }

    /** Loads a motion path along the x axis, with one frame per unit. */
    private void load(FxRobot robot, int from, int to) throws IOException, TimeoutException {
        Files.writeString(folder.resolve("way.path"), "lightning-path 1\nevery " + (to - from) + "\nat " + from
                + " 5 2 direction -3 -4 -2\nat " + to + " 5 2 direction -3 -4 -2\n");
        robot.clickOn("#load-animation");
        TestEditors.await(() -> status(robot).equals("2 keyframes over " + (to - from + 1) + " frames"));
    }

    private static double x(Scene scene) {
        return scene.light("key").orElseThrow().position().x();
    }

    private static String status(FxRobot robot) {
        return robot.lookup("#animation-status").queryAs(Label.class).getText();
    }

    private static TextField field(FxRobot robot, String id) {
        return robot.lookup("#" + id + " .number-field").queryAs(TextField.class);
    }

    private static void type(FxRobot robot, String id, String text) {
        robot.clickOn(field(robot, id)).push(KeyCode.SHORTCUT, KeyCode.A).write(text).push(KeyCode.ENTER);
    }
}
