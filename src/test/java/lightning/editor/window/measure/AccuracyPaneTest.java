package lightning.editor.window.measure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumSet;
import javafx.scene.Node;
import javafx.scene.control.TableView;
import javafx.scene.input.KeyCode;
import lightning.bench.accuracy.Grade;
import lightning.bench.accuracy.Rung;
import lightning.editor.document.Change;
import lightning.editor.document.Command;
import lightning.editor.document.Desk;
import lightning.editor.window.EditorDesk;
import lightning.editor.window.widget.PictureView;
import lightning.render.image.DifferencePicture;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.shading.ReferenceTracer;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

class AccuracyPaneTest extends EditorDesk {

    private void dim() {
        robot.interact(() -> model().editor().edit(scene -> Desk.dial("intensity").set(scene, "lamp", 0.25)));
    }

    private void measure() {
        click("measure");
        waitFor("it is measured", () -> !table().getItems().isEmpty());
    }

    private TableView<Rung> table() {
        return robot.lookup("#ladder").query();
    }

    private boolean isDisabled(String id) {
        return robot.lookup("#" + id).<Node>query().isDisabled();
    }

    private int[] shown() {
        return robot.lookup("#grade-picture").<PictureView>query().pixels();
    }

    @Test
    void withoutAnEdit_thereIsNothingToMeasure() {
        robot.push(KeyCode.F9);
        assertThat(isDisabled("measure")).isTrue();
        assertThat(isDisabled("cancel-measure")).isTrue();
        assertThat(text("accuracy-edit")).isEqualTo("Edit a light first.");
    }

    @Test
    void eachLevel_isMeasuredForTheEditsThatAreNotRenderedYet() {
        Scene before = model().editor().scene();
        dim();
        robot.push(KeyCode.F9);
        assertThat(text("accuracy-edit")).isEqualTo("The edits that are not rendered yet");
        measure();
        assertThat(table().getItems()).extracting(Rung::grade)
                .containsExactlyElementsOf(EnumSet.complementOf(EnumSet.of(Grade.FEW_SAMPLES, Grade.NO_ANTIALIASING)));
        assertThat(text("accuracy-edit")).isEqualTo("lamp: weight · 64 × 48 pixels");
        Rung exact = rung(Grade.EXACT);
        assertThat(exact.film().sameBits(new ReferenceTracer(model().editor().scene(), before).trace())).isTrue();
        assertThat(model().commands().isEnabled(Command.GO)).as("the document and its picture stay").isTrue();
    }

    @Test
    void chosenLevel_showsItsDifferenceFromTheFullTraceOrItself() {
        dim();
        click("go");
        waitForPicture();
        robot.push(KeyCode.F9);
        measure();
        Film full = new ReferenceTracer(model().editor().scene()).trace();
        Rung fast = rung(Grade.FAST_SHADING);
        robot.interact(() -> table().getSelectionModel().select(fast));
        assertThat(shown()).isEqualTo(ViewTransform.DEFAULT.toPixels(DifferencePicture.of(fast.film(), full)));
        click("grade-difference");
        assertThat(shown()).isEqualTo(ViewTransform.DEFAULT.toPixels(fast.film()));
        assertThat(text("grade-note")).startsWith("fast shading: ");
    }

    @Test
    void cancelledMeasuring_showsNothingAndCanBeginAgain() {
        // So large that it is not done before the click.
        robot.interact(() -> model().editor().edit(scene -> new Change.To(scene.withPicture(scene.picture().withSize(800, 600)))));
        click("go");
        waitForPicture();
        dim();
        robot.push(KeyCode.F9);
        click("measure");
        waitFor("it runs", () -> !isDisabled("cancel-measure"));
        click("cancel-measure");
        waitFor("it is cancelled", () -> text("accuracy-edit").equals("Cancelled"));
        assertThat(table().getItems()).isEmpty();
        assertThat(isDisabled("measure")).isFalse();
    }

    private Rung rung(Grade grade) {
        return table().getItems().stream().filter(r -> r.grade() == grade).findFirst().orElseThrow();
    }
}
