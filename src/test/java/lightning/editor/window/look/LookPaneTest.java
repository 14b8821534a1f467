package lightning.editor.window.look;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.Slider;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.Region;
import lightning.base.math.Rgb;
import lightning.document.LightEdits;
import lightning.document.OpenDocument;
import lightning.document.look.Lighting;
import lightning.document.look.LightingBlend;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.OwnEditor;
import lightning.editor.window.widget.PictureView;
import lightning.format.jen.JenReader;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;
import org.testfx.util.WaitForAsyncUtils;

@OwnEditor
class LookPaneTest extends EditorFixture {
    private Scene day;
    private Scene night;

    private void saveLook(String name) {
        robot.interact(() -> robot.lookup("#look-new-name").<TextField>query().setText(name));
        click("look-keep");
        waitFor("the look is kept", () -> robot.lookup("#look-" + name).tryQuery().isPresent());
    }

    private void go() {
        robot.interact(() -> model().commands().run(Command.GO));
        waitForPicture();
    }

    /** Saves two looks, of which the second is applied. */
    private void saveTwoLooks() {
        day = model().editor().scene();
        floatPanels();
        robot.push(KeyCode.SHIFT, KeyCode.F4);
        saveLook("day");
        robot.interact(() -> model().editor().edit(s -> LightEdits.edit(s, "lamp", l -> l.withColor(new Rgb(0.1, 0.1, 0.5)))));
        robot.interact(() -> model().editor().edit(s -> LightEdits.setOn(s, "sun", false)));
        go();
        night = model().editor().scene();
        saveLook("night");
    }

    private int[] shownPixels() {
        return robot.lookup("#look-picture").<PictureView>query().pixels();
    }

    private int[] pixels(Scene scene) {
        return model().picture().viewProperty().get().toPixels(new ReferenceTracer(scene).trace());
    }

    /** A comparison below took almost all of a low panel, so that no button of a look could be reached. */
    @Test
    void lowPanel_showsRowOfLooks() {
        robot.push(KeyCode.SHIFT, KeyCode.F4);
        saveLook("day");
        Region card = robot.lookup("#look-day").query();
        WaitForAsyncUtils.waitForFxEvents();
        Node scroll = card;
        while (!(scroll instanceof ScrollPane)) {
            scroll = scroll.getParent();
        }
        assertThat(card.getHeight()).isPositive().isLessThanOrEqualTo(((ScrollPane) scroll).getHeight());
    }

    @Test
    void untitledScene_keepsLooksUntilItIsSaved() throws Exception {
        OpenDocument copy = OpenDocument.openCopy(folder.resolve("desk.jen"));
        robot.interact(() -> model().open(copy));
        waitForPicture();
        floatPanels();
        robot.push(KeyCode.SHIFT, KeyCode.F4);
        saveLook("day");
        assertThat(folder.resolve("desk.cues")).doesNotExist();
        assertThat(model().editor().document().isDirty()).isTrue();
        answer = folder.resolve("mine.jen");
        Files.createDirectory(folder.resolve("mine.cues"));
        Files.writeString(folder.resolve("mine.cues/day.jen"), "of another scene");
        robot.interact(() -> model().commands().run(Command.SAVE_SCENE));
        waitFor("the scene is saved", () -> !model().editor().document().isDirty());
        assertThat(folder.resolve("mine.cues/day.jen")).hasContent("of another scene");
        assertThat(Lighting.read(folder.resolve("mine.cues/day 2.jen"), folder, model().editor().scene().stage()))
                .isEqualTo(Lighting.of(model().editor().scene()));
        assertThat(folder.resolve("mine.cues/day 2.png")).exists();
    }

    @Test
    void untitledScene_saysWhenItsLooksAreStored() throws Exception {
        OpenDocument copy = OpenDocument.openCopy(folder.resolve("desk.jen"));
        robot.interact(() -> model().open(copy));
        robot.push(KeyCode.SHIFT, KeyCode.F4);
        waitFor("the empty list says what to do", () -> robot.lookup(".look-gallery .pane-note").tryQuery().isPresent());
        assertThat(robot.lookup(".look-gallery .pane-note").<Label>query().getText())
                .isEqualTo("No looks yet. Saved looks appear here and are stored with the scene when you save it.");
    }

    @Test
    void looks_areSavedRestoredRenamedAndRecovered() throws Exception {
        saveTwoLooks();
        assertThat(JenReader.read(folder.resolve("desk.cues/night.jen")).scene().lights()).isEqualTo(night.lights());
        click("look-restore-day");
        assertThat(model().editor().scene()).isEqualTo(day);
        waitForPicture();
        assertFilmIs(new ReferenceTracer(day).trace());
        robot.push(KeyCode.CONTROL, KeyCode.Z);
        assertThat(model().editor().scene()).isEqualTo(night);
        waitForPicture();
        assertFilmIs(new ReferenceTracer(night).trace());
        robot.clickOn("#look-name-day");
        robot.interact(() -> robot.lookup("#look-name-day").<TextField>query().setText("noon"));
        robot.push(KeyCode.ENTER);
        waitFor("the look is renamed", () -> robot.lookup("#look-noon").tryQuery().isPresent());
        click("look-remove-noon");
        waitFor("the look is removed", () -> robot.lookup("#look-noon").tryQuery().isEmpty());
        click("look-back");
        waitFor("the look is restored", () -> robot.lookup("#look-noon").tryQuery().isPresent());
        assertThat(Files.exists(folder.resolve("desk.cues/noon.png"))).isTrue();
    }

    @Test
    void blend_betweenTwoLooks_isExactInOneUndoStep() {
        saveTwoLooks();
        click("look-a-day");
        click("look-b-night");
        Slider slider = robot.lookup("#look-blend").query();
        robot.interact(() -> slider.setValue(30));
        Lighting expected = LightingBlend.blend(Lighting.of(day), Lighting.of(night), 0.3);
        assertThat(Lighting.of(model().editor().scene())).isEqualTo(expected);
        assertThat(model().editor().editorStateProperty().get().undoLabel()).contains("Blend A/B 30 %");
        waitForPicture();
        assertFilmIs(new ReferenceTracer(model().editor().scene()).trace());
        robot.interact(() -> slider.setValue(100));
        assertThat(model().editor().scene()).isEqualTo(night);
        robot.interact(() -> slider.setValue(0));
        assertThat(model().editor().scene()).isEqualTo(day);
        robot.interact(() -> slider.setValue(100));
        robot.drag("#look-blend .thumb").moveBy(-60, 0).moveBy(-60, 0).drop();
        assertThat(model().editor().scene()).isNotEqualTo(night);
        robot.interact(() -> model().commands().run(Command.UNDO));
        assertThat(model().editor().scene()).isEqualTo(night);
    }

    @Test
    void comparedLooks_showWipeFlipAndDifference() {
        saveTwoLooks();
        click("look-a-day");
        click("look-b-night");
        assertThat(robot.lookup("#look-picture").<PictureView>query().wipe().isVisible()).isTrue();
        assertThat(shownPixels()).isEqualTo(pixels(night));
        click("look-flip");
        assertThat(shownPixels()).isEqualTo(pixels(day));
        assertThat(text("look-note")).isEqualTo("A: day");
        robot.clickOn("#look-picture");
        assertThat(shownPixels()).isEqualTo(pixels(night));
        assertThat(text("look-note")).isEqualTo("B: night");
        click("look-difference");
        int[] difference = shownPixels();
        int[] a = pixels(day);
        int[] b = pixels(night);
        for (int i = 0; i < a.length; i++) {
            assertThat(difference[i] == 0xFF000000).as("pixel %d", i).isEqualTo(a[i] == b[i]);
        }
        click("look-b-day");
        assertThat(text("look-note")).isEqualTo("The images are identical");
    }

    /** A zoomed comparison could not be fitted to its panel again. */
    @Test
    void doubleClick_fitsComparison() {
        saveTwoLooks();
        click("look-a-day");
        click("look-b-night");
        PictureView view = robot.lookup("#look-picture").query();
        double fitted = view.magnification();
        robot.interact(() -> view.zoomBy(40));
        assertThat(view.magnification()).isGreaterThan(fitted);
        robot.doubleClickOn("#look-picture");
        assertThat(view.magnification()).isEqualTo(fitted);
    }

    @Test
    void stalePicture_isNotSaved() {
        robot.interact(() -> model().editor().edit(s -> LightEdits.setOn(s, "sun", false)));
        robot.push(KeyCode.SHIFT, KeyCode.F4);
        assertThat(robot.lookup("#look-keep").query().isDisabled()).isTrue();
    }

    @Test
    void lightRig_isSavedLoadedAndAdded() throws Exception {
        Scene before = model().editor().scene();
        answer = folder.resolve("three.jen");
        robot.interact(() -> model().commands().run(Command.SAVE_RIG));
        waitFor("the file is written", () -> Files.exists(answer));
        assertThat(Files.readString(answer)).contains("light lamp point").doesNotContain("sphere");
        robot.interact(() -> model().editor().edit(s -> LightEdits.delete(s, "lamp")));
        robot.interact(() -> model().commands().run(Command.LOAD_RIG));
        waitFor("the lights are loaded", () -> model().editor().scene().lights().size() == 3);
        assertThat(model().editor().scene()).isEqualTo(before);
        robot.interact(() -> model().commands().run(Command.ADD_RIG));
        waitFor("the lights are added", () -> model().editor().scene().lights().size() == 6);
        go();
        robot.interact(() -> model().commands().run(Command.UNDO));
        assertThat(model().editor().scene()).isEqualTo(before);
        answer = model().editor().document().file();
        robot.interact(() -> model().commands().run(Command.SAVE_RIG));
        assertThat(model().editor().message().textProperty().get()).contains("is the open scene");
    }
}
