package lightning.editor.window.contribution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import javafx.geometry.Bounds;
import javafx.scene.control.TableView;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import lightning.document.LightEdits;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.ScreenBounds;
import lightning.editor.window.widget.PictureView;
import lightning.render.image.Film;
import lightning.render.relight.LightContribution;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;

class ContributionPaneTest extends EditorFixture {

    /** Opens the pane for a scene with one more light, which illuminates only the underside of the floor. */
    private Scene openWith(Light addedLight) {
        robot.interact(() -> model().editor().edit(s -> LightEdits.add(s, addedLight)));
        robot.interact(() -> model().commands().run(Command.GO));
        waitForPicture();
        robot.push(KeyCode.SHIFT, KeyCode.F5);
        waitFor("the contributions are shown", () -> text("contribution-summary").contains("displayed pixel")
                || text("contribution-summary").startsWith("Every"));
        return model().editor().scene();
    }

    private List<LightContribution> rows() {
        return List.copyOf(robot.lookup("#contribution-table").<TableView<LightContribution>>query().getItems());
    }

    @Test
    void idleLight_switchedOff_leavesPictureBitEqual() {
        Scene before = openWith(Light.of("below", LightType.POINT).withPosition(new lightning.base.math.Vec3(0, -50, 0)));
        Film old = model().picture().frame().film();
        assertThat(text("contribution-summary")).isEqualTo("1 light changes no displayed pixel: below");
        assertThat(rows()).extracting(row -> row.light().title(before)).containsExactly("lamp", "sun", "stage", "below");
        assertThat(ContributionPane.changeText(rows().getLast())).isEqualTo("bit-identical");
        assertThat(ContributionPane.changeText(rows().getFirst())).matches("\\d.* % of the pixels, up to [+-]\\d+\\.\\d stops");
        click("switch-off-idle");
        waitFor("the proof is shown", () -> text("contribution-proof").contains("bit-identical to the old one"));
        assertThat(light("below").on()).isFalse();
        assertFilmIs(new ReferenceTracer(model().editor().scene()).trace());
        assertFilmIs(old);
        waitFor("the summary is updated", () -> text("contribution-summary").startsWith("All lights"));
        robot.interact(() -> model().commands().run(Command.UNDO));
        assertThat(model().editor().scene()).isEqualTo(before);
    }

    @Test
    void shadowRays_sayWhatEachLightCosts() {
        Light soft = light("lamp").withName("soft");
        robot.interact(() -> model().editor().edit(s -> LightEdits.add(s, soft.withArea(soft.area().withRadius(0.5).withSamples(64)))));
        Scene scene = openWith(Light.of("below", LightType.POINT).withPosition(new lightning.base.math.Vec3(0, -50, 0)));
        TableView<LightContribution> table = robot.lookup("#contribution-table").query();
        var rays = table.getColumns().stream().filter(column -> column.getText().equals("Shadow Rays")).findFirst().orElseThrow();
        double all = 0;
        double ofSoft = 0;
        for (int row = 0; row < table.getItems().size(); row++) {
            double share = (double) rays.getCellData(row);
            all += share;
            ofSoft = table.getItems().get(row).light().title(scene).equals("soft") ? share : ofSoft;
        }
        assertThat(all).isCloseTo(1, within(1e-9));
        assertThat(ofSoft).as("a light with many samples").isGreaterThan(0.5);
    }

    @Test
    void invisibleLight_switchedOff_reportsLargestDifference() {
        openWith(light("lamp").withName("dim").withIntensity(1e-6));
        click("switch-off-idle");
        waitFor("the proof is shown", () -> text("contribution-proof").contains("no displayed pixel changed"));
        assertThat(light("dim").on()).isFalse();
    }

    @Test
    void regionAndPointer_haveOwnShares() {
        openWith(Light.of("below", LightType.POINT).withPosition(new lightning.base.math.Vec3(0, -50, 0)));
        double whole = rows().get(1).regionShare();
        click("contribution-region");
        assertThat(model().picturePointer().regionRequestProperty().get()).isNotNull();
        PictureView picture = robot.lookup("#traced-picture").query();
        Bounds at = ScreenBounds.of(picture);
        robot.interact(() -> picture.getScene().getWindow().requestFocus());
        robot.moveTo(at.getMinX() + 12, at.getCenterY() - 20).press(MouseButton.PRIMARY).moveBy(40, 30).release(MouseButton.PRIMARY);
        waitFor("the region is set", () -> text("contribution-region-text").contains("pixels at"));
        waitFor("the shares of the region are shown", () -> rows().get(1).regionShare() != whole);
        assertThat(rows().get(1).imageShare()).isEqualTo(whole);
        robot.moveTo(at.getMinX() + 30, at.getCenterY());
        waitFor("the share at the cursor is shown", () -> robot.lookup(".table-cell").queryAll().stream()
                .filter(c -> c instanceof javafx.scene.control.TableCell<?, ?> t && t.getTableColumn() != null
                        && "Cursor".equals(t.getTableColumn().getText()))
                .anyMatch(c -> ((javafx.scene.control.TableCell<?, ?>) c).getText() != null
                        && ((javafx.scene.control.TableCell<?, ?>) c).getText().endsWith("%")));
        click("contribution-whole");
        waitFor("the shares of the whole frame are shown", () -> rows().get(1).regionShare() == whole);
    }
}
