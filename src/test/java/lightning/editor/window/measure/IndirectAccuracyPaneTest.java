package lightning.editor.window.measure;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.css.PseudoClass;
import javafx.scene.Node;
import javafx.scene.control.TableView;
import lightning.editor.document.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.OwnEditor;
import lightning.render.measure.IndirectSweep;
import lightning.scene.IndirectSettings;
import org.junit.jupiter.api.Test;

@OwnEditor
class IndirectAccuracyPaneTest extends EditorFixture {
    private TableView<IndirectSweep.Point> table() {
        return robot.lookup("#indirect-table").query();
    }

    @Test
    void settings_areMeasuredAndUsed() {
        robot.interact(() -> model().commands().run(Command.INDIRECT_ACCURACY));
        click("measure-indirect");
        waitFor("the measurement is finished", () -> table().getItems().size() == 9);
        assertThat(table().getSelectionModel().getSelectedItem().settings()).isEqualTo(IndirectSettings.DEFAULT);
        robot.interact(() -> table().getSelectionModel().selectFirst());
        click("use-indirect-settings");
        assertThat(model().editor().scene().picture().indirect()).contains(IndirectSettings.DEFAULT.withSpacing(16).withRays(16));
    }

    @Test
    void pointOfTheChart_selectsItsSettings() {
        robot.interact(() -> model().commands().run(Command.INDIRECT_ACCURACY));
        assertThat(robot.lookup("#indirect-chart").<Node>query().isVisible()).isFalse();
        click("measure-indirect");
        waitFor("the measurement is finished", () -> table().getItems().size() == 9);
        assertThat(table().getItems()).allSatisfy(point -> assertThat(robot.lookup("#indirect-point-" + point.settings().spacing() + "-"
                + point.settings().rays()).queryAll()).hasSize(1));
        assertThat(isMarked("indirect-point-8-64", "selected")).isTrue();
        // Nothing is nearer to the densest setting than itself.
        assertThat(isMarked("indirect-point-4-256", "optimal")).isTrue();
        click("indirect-point-4-16");
        assertThat(table().getSelectionModel().getSelectedItem().settings())
                .isEqualTo(IndirectSettings.DEFAULT.withSpacing(4).withRays(16));
        assertThat(isMarked("indirect-point-4-16", "selected")).isTrue();
        assertThat(isMarked("indirect-point-8-64", "selected")).isFalse();
        click("use-indirect-settings");
        assertThat(model().editor().scene().picture().indirect()).contains(IndirectSettings.DEFAULT.withSpacing(4).withRays(16));
    }

    private boolean isMarked(String id, String state) {
        return robot.lookup("#" + id).<Node>query().getPseudoClassStates().contains(PseudoClass.getPseudoClass(state));
    }
}
