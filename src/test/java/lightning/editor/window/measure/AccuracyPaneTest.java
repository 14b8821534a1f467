package lightning.editor.window.measure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumSet;
import javafx.scene.Node;
import javafx.scene.control.TableView;
import javafx.scene.input.KeyCode;
import lightning.document.DeskScene;
import lightning.document.EditOutcome;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.OwnEditor;
import lightning.editor.window.widget.PictureView;
import lightning.render.image.DifferenceImage;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.measure.AccuracySetting;
import lightning.render.measure.SweepPoint;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

@OwnEditor
class AccuracyPaneTest extends EditorFixture {

    private void dim() {
        robot.interact(() -> model().editor().edit(scene -> DeskScene.parameter("intensity").set(scene, "lamp", 0.25)));
    }

    private void measure() {
        click("measure");
        waitFor("the measurement is finished", () -> !table().getItems().isEmpty());
    }

    private TableView<SweepPoint> table() {
        return robot.lookup("#ladder").query();
    }

    private boolean isDisabled(String id) {
        return robot.lookup("#" + id).<Node>query().isDisabled();
    }

    private int[] shownPixels() {
        return robot.lookup("#grade-picture").<PictureView>query().pixels();
    }

    @Test
    void withoutEdit_measureIsDisabled() {
        robot.push(KeyCode.F9);
        assertThat(isDisabled("measure")).isTrue();
        assertThat(isDisabled("cancel-measure")).isTrue();
        assertThat(text("accuracy-edit")).isEqualTo("Edit a light first.");
    }

    @Test
    void everyLevel_isMeasuredForPendingEdits() {
        Scene before = model().editor().scene();
        dim();
        robot.push(KeyCode.F9);
        assertThat(text("accuracy-edit")).isEqualTo("Edits not rendered yet");
        measure();
        assertThat(table().getItems()).extracting(SweepPoint::setting)
                .containsExactlyElementsOf(EnumSet.complementOf(EnumSet.of(AccuracySetting.FEW_SAMPLES, AccuracySetting.NO_ANTIALIASING)));
        assertThat(text("accuracy-edit")).isEqualTo("lamp: weight · 64 × 48 pixels");
        SweepPoint exact = sweepPoint(AccuracySetting.EXACT);
        assertThat(exact.film().hasSameBits(new ReferenceTracer(model().editor().scene(), before).trace())).isTrue();
        assertThat(model().commands().isEnabled(Command.GO)).as("document and picture are unchanged").isTrue();
    }

    @Test
    void selectedLevel_showsPictureOrDifference() {
        dim();
        click("go");
        waitForPicture();
        robot.push(KeyCode.F9);
        measure();
        Film full = new ReferenceTracer(model().editor().scene()).trace();
        SweepPoint fast = sweepPoint(AccuracySetting.FAST_SHADING);
        robot.interact(() -> table().getSelectionModel().select(fast));
        assertThat(shownPixels()).isEqualTo(ViewTransform.DEFAULT.toPixels(DifferenceImage.of(fast.film(), full)));
        click("grade-difference");
        assertThat(shownPixels()).isEqualTo(ViewTransform.DEFAULT.toPixels(fast.film()));
        assertThat(text("grade-note")).startsWith("fast shading: ");
    }

    @Test
    void canceledMeasurement_showsNothingAndCanRestart() {
        // Large enough to still run at the click.
        robot.interact(
                () -> model().editor().edit(scene -> new EditOutcome.Applied(scene.withPicture(scene.picture().withSize(800, 600)))));
        click("go");
        waitForPicture();
        dim();
        robot.push(KeyCode.F9);
        click("measure");
        waitFor("the measurement runs", () -> !isDisabled("cancel-measure"));
        click("cancel-measure");
        waitFor("the measurement is canceled", () -> text("accuracy-edit").equals("Canceled"));
        assertThat(table().getItems()).isEmpty();
        assertThat(isDisabled("measure")).isFalse();
    }

    private SweepPoint sweepPoint(AccuracySetting grade) {
        return table().getItems().stream().filter(r -> r.setting() == grade).findFirst().orElseThrow();
    }
}
