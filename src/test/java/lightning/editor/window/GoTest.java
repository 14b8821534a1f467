package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.util.List;
import java.util.concurrent.TimeUnit;
import javafx.application.Platform;
import javafx.scene.control.Button;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.Spinner;
import javafx.scene.control.TextField;
import javafx.scene.control.ToolBar;
import javafx.scene.input.KeyCode;
import lightning.base.work.Await;
import lightning.document.AttributeNumber;
import lightning.document.DeskScene;
import lightning.document.EditOutcome;
import lightning.document.LightEdits;
import lightning.document.OpenDocument;
import lightning.document.PictureArea;
import lightning.editor.Command;
import lightning.editor.window.model.AccuracyMode;
import lightning.render.image.Film;
import lightning.render.measure.WarmSaving;
import lightning.render.relight.FilmError;
import lightning.render.relight.UpdateResult;
import lightning.render.shading.RayCounts;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.TransparentScenes;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.ViewEffects;
import lightning.scene.light.Light;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.testfx.util.WaitForAsyncUtils;

class GoTest extends EditorFixture {

    private void usePaperAccuracy() {
        robot.interact(() -> model().accuracyModeProperty().set(AccuracyMode.ON_DEMAND));
        waitForPicture();
    }

    private void dim() {
        robot.interact(() -> model().editor().edit(scene -> DeskScene.parameter("intensity").set(scene, "lamp", 0.25)));
    }

    /** Adds enough lights that a large picture takes noticeable time. */
    private void manyLights() {
        robot.interact(() -> {
            // Many shadow rays in little memory.
            model().editor().edit(scene -> {
                Light lamp = scene.light("lamp").orElseThrow();
                return new EditOutcome.Applied(scene.withLight(lamp.withArea(lamp.area().withRadius(0.5).withSamples(64))));
            });
            for (int i = 0; i < 20; i++) {
                model().editor().edit(scene -> LightEdits.duplicate(scene, "lamp"));
            }
        });
    }

    private MenuItem sizeItem(String id) {
        return robot.lookup("#traced-sizes").<MenuButton>query().getItems().stream().filter(i -> id.equals(i.getId()))
                .findFirst().orElseThrow();
    }

    private void size(int width, int height) {
        robot.interact(sizeItem("size-" + width + "x" + height)::fire);
    }

    @Test
    void openedScene_isTracedAndGoIsDisabled() {
        assertThat(isEnabled(Command.GO)).isFalse();
        assertThat(model().commands().disabledReason(Command.GO)).contains("nothing to render");
        assertFilmIs(new ReferenceTracer(model().editor().scene()).trace());
        assertThat(text("status")).matches("Traced in [0-9.]+ m?s, exact");
        assertThat(telemetry()).contains("full render").contains("exact");
    }

    @Test
    void edit_enablesGoAndMarksTheCanvas() {
        dim();
        assertThat(isEnabled(Command.GO)).isTrue();
        waitFor("the canvas is marked", () -> isShown("pending"));
        assertThat(text("pending")).isEqualTo("Out of date. Render (F5)");
    }

    @Test
    void go_showsEditAndItsCost() {
        dim();
        click("go");
        waitForPicture();
        assertThat(isEnabled(Command.GO)).isFalse();
        assertThat(isShown("pending")).isFalse();
        assertThat(text("status")).matches("Updated in [0-9.]+ m?s, exact");
        assertThat(telemetry()).contains("lamp: weight").contains("0 shadow rays");
        waitFor("the saving is measured", () -> model().picture().renderStateProperty().get().saving().isPresent());
        // Either is possible, depending on the machine: the picture is tiny.
        assertThat(telemetry()).contains("full trace ").containsPattern("% (saved|slower)");
    }

    @Test
    void go_updatesMirrorsToo() {
        dim();
        click("go");
        waitForPicture();
        assertFilmIs(new ReferenceTracer(model().editor().scene()).trace());
        assertCanvasShows(new ReferenceTracer(model().editor().scene()).trace());
        assertThat(isShown("mirrors")).isFalse();
        assertThat(model().commands().disabledReason(Command.UPDATE_REFLECTIONS)).contains("reflections are up to date");
    }

    @Test
    void antialiasingOn_isNotComparedWithOtherTime() {
        dim();
        click("go");
        waitForPicture();
        waitFor("the saving is measured", () -> model().picture().renderStateProperty().get().saving().isPresent());
        WarmSaving firstSaving = model().picture().renderStateProperty().get().measuredSaving();
        robot.interact(() -> model().editor().edit(scene -> new EditOutcome.Applied(scene.withPicture(scene.picture().withSampling(
                new SamplingSettings(AntialiasMode.EDGES, 2))))));
        click("go");
        waitFor("the saving is measured again", () -> model().picture().renderStateProperty().get().measuredSaving() != firstSaving);
        assertThat(model().picture().renderStateProperty().get().measuredSaving().isOf(model().picture().frame().update())).isTrue();
        assertThat(model().picture().frame().update().plan().description()).contains("samples");
    }

    @Test
    void staleGo_matchesStaleReference() {
        usePaperAccuracy();
        Scene mirrored = model().editor().scene();
        dim();
        click("go");
        waitForPicture();
        assertFilmIs(new ReferenceTracer(model().editor().scene(), mirrored).trace());
        assertCanvasShows(new ReferenceTracer(model().editor().scene(), mirrored).trace());
        assertThat(text("status")).contains("reflections out of date");
    }

    @Test
    void goAndUpdateReflections_matchFullTrace() {
        usePaperAccuracy();
        dim();
        click("go");
        waitForPicture();
        assertThat(isEnabled(Command.UPDATE_REFLECTIONS)).isTrue();
        click("update-reflections");
        waitFor("the mirrors are current", () -> !model().commands().isEnabled(Command.UPDATE_REFLECTIONS)
                && model().editor().editorStateProperty().get().sceneInProgress().isEmpty());
        assertFilmIs(new ReferenceTracer(model().editor().scene()).trace());
    }

    @Test
    void undoAfterGo_leavesGoEnabled() {
        dim();
        click("go");
        waitForPicture();
        click("undo");
        assertThat(light("lamp").intensity()).isEqualTo(1);
        assertThat(isEnabled(Command.GO)).isTrue();
        click("redo");
        assertThat(isEnabled(Command.GO)).isFalse();
    }

    @Test
    void shortcut_equalsButton() {
        dim();
        robot.push(KeyCode.F5);
        waitForPicture();
        assertThat(model().picture().frame().scene().light("lamp").orElseThrow().intensity()).isEqualTo(0.25);
    }

    @Test
    void live_rendersWithoutGo() {
        click("live");
        dim();
        waitForPicture();
        assertThat(model().picture().frame().scene().light("lamp").orElseThrow().intensity()).isEqualTo(0.25);
    }

    @Test
    void depthSpinner_isUndoableEdit() {
        // In a narrow window, the field is in the tool bar's overflow menu.
        Spinner<?> depth = robot.lookup("#toolbar").<ToolBar>query().getItems().stream()
                .flatMap(item -> item.lookupAll(".spinner").stream()).map(Spinner.class::cast).findFirst().orElseThrow();
        robot.interact(() -> depth.increment());
        assertThat(model().editor().scene().picture().depth()).isEqualTo(3);
        assertThat(isEnabled(Command.GO)).isTrue();
        click("undo");
        assertThat(model().editor().scene().picture().depth()).isEqualTo(2);
    }

    @Test
    void otherSize_isRetraced() {
        size(200, 200);
        waitForPicture();
        assertThat(model().picture().frame().film().width()).isEqualTo(200);
        assertThat(model().picture().raster().pixels().pixels())
                .isEqualTo(model().picture().viewProperty().get().toPixels(model().picture().frame().film()));
    }

    @Test
    void sizes_includeFourToThree() {
        for (String size : new String[] {"320x240", "640x480", "1024x768"}) {
            assertThat(sizeItem("size-" + size)).isNotNull();
        }
    }

    @Test
    void sceneSize_canBeRestored() {
        assertThat(sizeItem("size-own").getText()).isEqualTo("Scene Default (64 × 48)");
        size(200, 200);
        robot.interact(sizeItem("size-own")::fire);
        waitForPicture();
        assertThat(model().picture().frame().film().width()).isEqualTo(64);
        assertThat(model().picture().frame().film().height()).isEqualTo(48);
    }

    @Test
    void paneSize_isLargestOfSameAspectRatioThatFits() {
        robot.interact(sizeItem("size-pane")::fire);
        waitFor("the picture is traced", () -> model().picture().frame().film().width() > 64);
        PictureArea pane = model().layout().pictureArea();
        int width = model().editor().scene().picture().width();
        int height = model().editor().scene().picture().height();
        assertThat(width).isLessThanOrEqualTo((int) pane.width());
        assertThat(height).isLessThanOrEqualTo((int) pane.height());
        assertThat(width + 1 > pane.width() || height + 1 > pane.height()).as("%d × %d in %s", width, height, pane).isTrue();
        assertThat((double) width / height).isCloseTo(4 / 3.0, Offset.offset(0.01));
    }

    @Test
    void pictureOfThePane_hasItsSizeAndTheSceneKeepsItsOwn() {
        Scene scene = model().editor().scene();
        robot.interact(sizeItem("working-pane")::fire);
        waitFor("the picture is traced", () -> model().picture().frame().film().width() > 64);
        PictureArea pane = model().layout().pictureArea();
        Scene shown = model().picture().frame().scene();
        assertThat(shown.picture()).isEqualTo(pane.size(scene.picture()));
        assertThat(model().editor().scene()).isEqualTo(scene);
        assertThat(isEnabled(Command.GO)).isFalse();
        robot.interact(sizeItem("working-scene")::fire);
        waitFor("the picture is traced", () -> model().picture().frame().film().width() == 64);
    }

    private void typeSize(String typed) {
        MenuItem other = sizeItem("size-other");
        Platform.runLater(other::fire);
        waitFor("the dialog opens", () -> robot.lookup(".text-input-dialog .text-field").tryQuery().isPresent());
        robot.interact(() -> robot.lookup(".text-input-dialog .text-field").<TextField>query().setText(typed));
        robot.clickOn("OK");
    }

    @Test
    void typedSize_isRetraced() {
        typeSize("50 x 40");
        waitFor("the picture is traced", () -> model().picture().frame().film().width() == 50);
        assertThat(model().picture().frame().film().height()).isEqualTo(40);
    }

    @Test
    void typedNonsense_showsError() {
        typeSize("large");
        waitFor("the error is shown", () -> text("message").contains("640 × 480, found 'large'"));
        assertThat(isEnabled(Command.UNDO)).isFalse();
    }

    @Test
    void longTrace_showsCancelableProgressInResponsiveWindow() throws Exception {
        Scene before = model().picture().frame().scene();
        manyLights();
        size(1920, 1080);
        waitFor("progress is shown", () -> isShown("progress"));
        assertThat(WaitForAsyncUtils.asyncFx(() -> true).get(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS)).isTrue();
        robot.interact(robot.lookup("#cancel-progress").<Button>query()::fire);
        waitFor("the progress bar is hidden", () -> !isShown("progress"));
        assertThat(model().picture().frame().scene()).isEqualTo(before);
        assertThat(isEnabled(Command.GO)).isTrue();
    }

    @Test
    void verify_confirmsFullTraceEquality() {
        click("verify");
        waitFor("the picture is verified", () -> model().picture().renderStateProperty().get().verification() != null);
        assertThat(text("status")).startsWith("Verified: equal to a full trace in every bit");
        assertThat(isShown("difference")).isTrue();
    }

    @Test
    void verify_withStaleMirrors_reportsThem() {
        usePaperAccuracy();
        dim();
        click("go");
        waitForPicture();
        click("verify");
        waitFor("the picture is verified", () -> model().picture().renderStateProperty().get().verification() != null);
        assertThat(text("status")).startsWith("Verified: equal to a full trace with outdated reflections in every bit")
                .contains("would change with current reflections");
    }

    @Test
    void updatedReflections_clearVerificationAndDifference() {
        usePaperAccuracy();
        dim();
        click("go");
        waitForPicture();
        click("verify");
        waitFor("the picture is verified", () -> model().picture().renderStateProperty().get().verification() != null);
        click("difference");
        Object verified = model().picture().frame();
        click("update-reflections");
        waitFor("the mirrors are new", () -> model().picture().frame() != verified);
        waitFor("the verdict is gone", () -> !text("status").contains("Verified"));
        assertThat(isShown("difference")).isFalse();
        assertCanvasShows(new ReferenceTracer(model().editor().scene()).trace());
    }

    @Test
    void anotherAccuracy_castsNoRay() {
        for (AccuracyMode precision : new AccuracyMode[] {AccuracyMode.RATIO, AccuracyMode.EXACT, AccuracyMode.ON_DEMAND}) {
            Object before = model().picture().frame();
            robot.interact(() -> model().accuracyModeProperty().set(precision));
            waitFor("the picture is rendered", () -> model().picture().frame() != before);
            UpdateResult update = model().picture().frame().update();
            assertThat(update.rays()).as(precision.toString()).isEqualTo(RayCounts.NONE);
            Film exact = new ReferenceTracer(model().editor().scene()).trace();
            if (precision == AccuracyMode.RATIO) {
                assertThat(FilmError.largestError(model().picture().frame().film(), exact)).isLessThanOrEqualTo(update.errorBound());
            } else {
                assertFilmIs(exact);
            }
        }
    }

    @Test
    void staleMirrors_showBadgeUntilClickUpdatesThem() {
        usePaperAccuracy();
        dim();
        click("go");
        waitFor("the message is shown", () -> isShown("mirrors"));
        assertThat(text("mirrors")).isEqualTo("Reflections out of date. Click to update");
        click("mirrors");
        waitFor("the mirrors are updated", () -> !isShown("mirrors"));
        assertFilmIs(new ReferenceTracer(model().editor().scene()).trace());
    }

    /** Hidden reflections still show transparency, which can be out of date as well. */
    @Test
    void staleGlass_showsBadgeUntilClickUpdatesIt() throws Exception {
        OpenDocument glass = OpenDocument.open(Files.writeString(folder.resolve("glass.jen"), TransparentScenes.BALL));
        usePaperAccuracy();
        robot.interact(() -> model().open(glass));
        waitForPicture();
        assertThat(isEnabled(Command.UPDATE_REFLECTIONS)).isFalse();
        dim();
        click("go");
        waitForPicture();
        assertThat(text("status")).contains("reflections out of date");
        assertThat(isEnabled(Command.UPDATE_REFLECTIONS)).isTrue();
        robot.interact(() -> model().pictureDisplay().effectsProperty().set(ViewEffects.ALL.with(RenderEffect.REFLECTION, false)));
        waitFor("the look is shown", () -> !model().picture().frame().displayMode().isFullPicture());
        waitFor("the message is shown", () -> isShown("mirrors"));
        click("mirrors");
        waitFor("the mirrors are updated", () -> !isShown("mirrors"));
        assertFilmIs(new ReferenceTracer(model().editor().scene()).trace());
        assertThat(isEnabled(Command.UPDATE_REFLECTIONS)).isFalse();
    }

    @Test
    void mirrorsWithDeletedLights_areExplained() {
        usePaperAccuracy();
        robot.interact(() -> List.of("lamp", "sun", "stage").forEach(l -> model().editor().edit(scene -> LightEdits.delete(scene, l))));
        click("go");
        waitFor("the message is shown", () -> isShown("mirrors"));
        assertThat(text("mirrors")).isEqualTo("No lights on; reflections out of date. Click to update");
        robot.interact(() -> model().accuracyModeProperty().set(AccuracyMode.EXACT));
        waitFor("the mirrors are updated", () -> !isShown("mirrors"));
        assertFilmIs(new ReferenceTracer(model().editor().scene()).trace());
    }

    @Test
    void sceneWithoutMirrors_neverShowsMirrorBadge() {
        usePaperAccuracy();
        robot.interact(() -> model().editor().edit(scene -> AttributeNumber.DEPTH.set(scene, "", 0)));
        click("go");
        waitForPicture();
        dim();
        click("go");
        waitForPicture();
        assertThat(model().editor().editorStateProperty().get().staleMirrorsMessage()).isEmpty();
        assertThat(text("status")).endsWith("exact");
    }
}
