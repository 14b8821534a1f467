package lightning.editor.window.timeline;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.util.List;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import lightning.document.DeskScene;
import lightning.document.OpenDocument;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.OwnEditor;
import lightning.format.jen.JenReader;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.SceneElement;
import lightning.scene.shot.Interpolation;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.KeyframeValue;
import lightning.scene.shot.Track;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

@OwnEditor
class TimelinePaneTest extends EditorFixture {
    private static final String SHOT = """
            shot {
              frames 1 25
              light lamp { intensity { 1 0.5  25 2.5 smooth } }
              light stage { on { 1 yes  10 no } }
            }
            """;

    @BeforeEach
    void openShot() throws Exception {
        var file = folder.resolve("desk.jen");
        Files.writeString(file, Files.readString(file) + SHOT);
        OpenDocument opened = OpenDocument.open(file);
        robot.interact(() -> model().open(opened));
        waitForPicture();
    }

    private Node node(String id) {
        return robot.lookup("#" + id).query();
    }

    private int frame() {
        return model().editor().document().shotFrame().orElseThrow().frame();
    }

    private List<Keyframe> keys() {
        return model().editor().document().content().shot().orElseThrow().track(new SceneElement.OfLight("lamp"), "intensity")
                .map(Track::keys)
                .orElse(List.of());
    }

    private static Keyframe key(int frame, Interpolation passage, double number) {
        return new Keyframe(frame, new KeyframeValue.Numbers(List.of(number)), passage);
    }

    /** Returns the screen position of a frame on the ruler. */
    private Point2D onRuler(int frame) {
        Node ruler = node("timeline-ruler");
        Bounds bounds = ruler.getBoundsInLocal();
        return ruler.localToScreen(FrameScale.of(model().editor().document().content().shot().orElseThrow(), bounds.getWidth()).x(frame),
                8);
    }

    private void dial(double intensity) {
        robot.interact(() -> model().editor()
                .edit(scene -> DeskScene.parameter("intensity").set(scene, "lamp", intensity)));
    }

    private void press(KeyCode... keys) {
        robot.push(keys);
    }

    @Test
    void sceneWithShot_showsFirstFrameAndTimeline() {
        assertThat(frame()).isEqualTo(1);
        assertThat(isShown("key-lamp-intensity-25")).isTrue();
        assertThat(light("lamp").intensity()).isEqualTo(0.5);
        assertCanvasShows(new ReferenceTracer(model().editor().scene()).trace());
    }

    @Test
    void rulerDrag_showsEachFrameExactly() {
        robot.drag(onRuler(1), MouseButton.PRIMARY).moveTo(onRuler(7)).moveTo(onRuler(13)).drop();
        assertThat(frame()).isEqualTo(13);
        assertThat(light("lamp").intensity()).isEqualTo(1.5);
        assertThat(light("stage").on()).isFalse();
        waitForPicture();
        assertCanvasShows(new ReferenceTracer(model().editor().document().content().sceneAt(13)).trace());
        assertThat(model().editor().document().isDirty()).isFalse();
        assertThat(model().editor().document().history().steps()).isEmpty();
    }

    @Test
    void editOfKeyedAttribute_setsKeyAtFrame() throws Exception {
        robot.clickOn(onRuler(13));
        dial(0.75);
        assertThat(keys()).containsExactly(key(1, Interpolation.LINEAR, 0.5), key(13, Interpolation.LINEAR, 0.75),
                key(25, Interpolation.SMOOTH, 2.5));
        assertThat(isShown("key-lamp-intensity-13")).isTrue();
        assertThat(model().editor().document().history().undoLabel()).contains("lamp: intensity at frame 13");
        assertGoShowsTheScene();
        robot.interact(() -> model().commands().run(Command.SAVE_SCENE));
        waitFor("the scene is saved", () -> !model().editor().document().isDirty());
        assertThat(JenReader.read(folder.resolve("desk.jen")).animatedScene()).isEqualTo(model().editor().document().content());
        press(KeyCode.CONTROL, KeyCode.Z);
        assertThat(keys()).hasSize(2);
        assertThat(light("lamp").intensity()).isEqualTo(1.5);
        assertThat(frame()).isEqualTo(13);
    }

    @Test
    void editOfUnkeyedAttribute_changesAllFrames() {
        robot.clickOn(onRuler(13));
        robot.interact(
                () -> model().editor().edit(scene -> DeskScene.parameter("intensity").set(scene, "sun", 0.9)));
        assertThat(keys()).hasSize(2);
        assertThat(model().editor().document().content().sceneAt(1).light("sun").orElseThrow().intensity()).isEqualTo(0.9);
        assertThat(model().editor().document().content().base().light("lamp").orElseThrow().intensity()).isEqualTo(1);
    }

    @Test
    void draggedKey_movesInOneUndoStep() {
        Point2D from = robot.point("#key-lamp-intensity-25").query();
        double step = onRuler(2).getX() - onRuler(1).getX();
        robot.drag(from, MouseButton.PRIMARY).moveTo(from.subtract(3 * step, 0)).moveTo(from.subtract(5 * step, 0)).drop();
        assertThat(keys()).containsExactly(key(1, Interpolation.LINEAR, 0.5), key(20, Interpolation.SMOOTH, 2.5));
        assertThat(model().keySelection().keys()).hasSize(1);
        robot.interact(() -> model().commands().run(Command.UNDO));
        assertThat(keys()).containsExactly(key(1, Interpolation.LINEAR, 0.5), key(25, Interpolation.SMOOTH, 2.5));
    }

    @Test
    void selectedKey_isSteppedAndDeleted() {
        robot.clickOn("#key-lamp-intensity-25");
        assertThat(isEnabled(Command.STEPPED_KEYS)).isTrue();
        click("stepped-keys");
        assertThat(keys().getLast().interpolation()).isEqualTo(Interpolation.STEPPED);
        robot.clickOn("#key-lamp-intensity-25");
        press(KeyCode.DELETE);
        assertThat(keys()).containsExactly(key(1, Interpolation.LINEAR, 0.5));
        assertThat(isEnabled(Command.DELETE_KEYS)).isFalse();
        robot.clickOn("#key-lamp-intensity-1");
        press(KeyCode.DELETE);
        assertThat(keys()).isEmpty();
        assertThat(model().editor().document().content().base().light("lamp").orElseThrow().intensity()).isEqualTo(0.5);
    }

    @Test
    void doubleClickOnLane_addsKeyWithCurrentValue() {
        Point2D line = robot.point("#key-lamp-intensity-1").query();
        robot.doubleClickOn(new Point2D(onRuler(7).getX(), line.getY()));
        assertThat(keys()).containsExactly(key(1, Interpolation.LINEAR, 0.5), key(7, Interpolation.LINEAR, 1),
                key(25, Interpolation.SMOOTH, 2.5));
    }

    @Test
    void stepsAndTypedFrame_showFrames() {
        click("next-frame");
        assertThat(frame()).isEqualTo(2);
        click("next-key");
        assertThat(frame()).isEqualTo(10);
        click("last-frame");
        assertThat(frame()).isEqualTo(25);
        assertThat(isEnabled(Command.NEXT_FRAME)).isFalse();
        click("previous-key");
        assertThat(frame()).isEqualTo(10);
        TextField field = robot.lookup("#timeline-frame").query();
        robot.clickOn(field);
        robot.interact(() -> field.setText("17"));
        press(KeyCode.ENTER);
        assertThat(frame()).isEqualTo(17);
        click("first-frame");
        assertThat(frame()).isEqualTo(1);
        waitForPicture();
        assertCanvasShows(new ReferenceTracer(model().editor().document().content().sceneAt(1)).trace());
    }

    @Test
    void playback_runsInRealTimeAndStopsAtEdit() {
        click("play-shot");
        waitFor("frames are shown", () -> frame() > 3);
        dial(3);
        waitFor("playback stops", () -> !model().commands().toggleState(Command.PLAY_SHOT).orElseThrow().getValue());
        int stopped = frame();
        assertThat(keys()).anySatisfy(k -> assertThat(k.value()).isEqualTo(new KeyframeValue.Numbers(List.of(3.0))));
        assertGoShowsTheScene();
        assertThat(frame()).isEqualTo(stopped);
    }

    @Test
    void propertyMenu_setsFirstKey() {
        robot.interact(() -> model().editor().selection().selectLight("sun"));
        robot.clickOn(onRuler(5));
        robot.clickOn("#intensity .label", MouseButton.SECONDARY);
        robot.clickOn("Set Keyframe of Intensity at Frame 5");
        assertThat(
                model().editor().document().content().shot().orElseThrow().track(new SceneElement.OfLight("sun"), "intensity").orElseThrow()
                        .keys())
                .containsExactly(key(5, Interpolation.LINEAR, 0.4));
        assertThat(isShown("key-sun-intensity-5")).isTrue();
        robot.clickOn("#intensity .label", MouseButton.SECONDARY);
        robot.clickOn("Clear Keyframes of Intensity");
        assertThat(model().editor().document().content().shot().orElseThrow().track(new SceneElement.OfLight("sun"), "intensity"))
                .isEmpty();
    }

    @Test
    void newRange_isOneUndoStepAndClampsFrame() {
        click("last-frame");
        TextField field = robot.lookup("#timeline-last-frame").query();
        robot.clickOn(field);
        robot.interact(() -> field.setText("12"));
        press(KeyCode.ENTER);
        assertThat(model().editor().document().content().shot().orElseThrow().last()).isEqualTo(12);
        assertThat(frame()).isEqualTo(12);
        assertThat(model().editor().document().history().undoLabel()).contains("frames 1 to 12");
    }

    @Test
    void deletedShot_keepsSceneOfFrame() {
        robot.clickOn(onRuler(13));
        robot.interact(() -> model().commands().run(Command.DELETE_SHOT));
        assertThat(model().editor().document().shotFrame()).isEmpty();
        assertThat(light("lamp").intensity()).isEqualTo(1.5);
        assertThat(isShown("new-shot")).isTrue();
        robot.interact(() -> model().commands().run(Command.UNDO));
        assertThat(keys()).hasSize(2);
        robot.interact(() -> model().commands().run(Command.REDO));
        robot.interact(() -> model().commands().run(Command.NEW_SHOT));
        assertThat(frame()).isEqualTo(1);
    }

    @Test
    void lightUndo_restoresItsKeys() {
        robot.interact(() -> model().editor().selection().selectLight("lamp"));
        dial(0.25);
        robot.interact(
                () -> model().editor().edit(scene -> DeskScene.parameter("intensity").set(scene, "sun", 0.9)));
        robot.interact(() -> model().commands().run(Command.UNDO_LIGHT));
        assertThat(keys()).containsExactly(key(1, Interpolation.LINEAR, 0.5), key(25, Interpolation.SMOOTH, 2.5));
        assertThat(light("sun").intensity()).isEqualTo(0.9);
    }
}
