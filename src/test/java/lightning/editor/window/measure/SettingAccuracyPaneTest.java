package lightning.editor.window.measure;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.css.PseudoClass;
import javafx.scene.Node;
import javafx.scene.control.ComboBox;
import javafx.scene.control.TableView;
import lightning.document.EditOutcome;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.OwnEditor;
import lightning.render.measure.SettingSweep;
import lightning.render.measure.SweptSetting;
import lightning.scene.IndirectSettings;
import org.junit.jupiter.api.Test;

@OwnEditor
class SettingAccuracyPaneTest extends EditorFixture {
    private TableView<SettingSweep.Point> table() {
        return robot.lookup("#setting-table").query();
    }

    @Test
    void settings_areMeasuredAndUsed() {
        robot.interact(() -> model().commands().run(Command.COMPARE_SETTINGS));
        click("measure-setting");
        waitFor("the measurement is finished", () -> table().getItems().size() == 9);
        assertThat(table().getSelectionModel().getSelectedItem().setting()).isEqualTo(new SweptSetting.Gathering(8, 64));
        robot.interact(() -> table().getSelectionModel().selectFirst());
        click("use-setting");
        assertThat(model().editor().scene().picture().indirect()).contains(IndirectSettings.DEFAULT.withSpacing(16).withRays(16));
    }

    @Test
    void pointOfTheChart_selectsItsSettings() {
        robot.interact(() -> model().commands().run(Command.COMPARE_SETTINGS));
        assertThat(robot.lookup("#setting-chart").<Node>query().isVisible()).isFalse();
        click("measure-setting");
        waitFor("the measurement is finished", () -> table().getItems().size() == 9);
        assertThat(table().getItems()).allSatisfy(point -> assertThat(robot.lookup("#setting-point-"
                + SettingText.id(point.setting())).queryAll()).hasSize(1));
        assertThat(isMarked("setting-point-8-64", "selected")).isTrue();
        // Nothing is nearer to the densest setting than itself.
        assertThat(isMarked("setting-point-4-256", "optimal")).isTrue();
        click("setting-point-4-16");
        assertThat(table().getSelectionModel().getSelectedItem().setting()).isEqualTo(new SweptSetting.Gathering(4, 16));
        assertThat(isMarked("setting-point-4-16", "selected")).isTrue();
        assertThat(isMarked("setting-point-8-64", "selected")).isFalse();
        click("use-setting");
        assertThat(model().editor().scene().picture().indirect()).contains(IndirectSettings.DEFAULT.withSpacing(4).withRays(16));
    }

    @Test
    void samplesOfAreaLights_areMeasuredAndUsed() {
        robot.interact(() -> model().commands().run(Command.COMPARE_SETTINGS));
        robot.interact(() -> robot.lookup("#swept-effect").queryAs(ComboBox.class).getSelectionModel().selectLast());
        assertThat(robot.lookup("#measure-setting").<Node>query().isDisabled()).as("no area light").isTrue();
        robot.interact(() -> model().editor().edit(scene -> EditOutcome.of(() -> scene.withLights(scene.lights().stream()
                .map(light -> light.withArea(light.area().withRadius(0.3).withSpread(3))).toList()))));
        click("measure-setting");
        waitFor("the measurement is finished", () -> table().getItems().size() == 5);
        assertThat(table().getSelectionModel().getSelectedItem().setting()).as("used by the scene")
                .isEqualTo(new SweptSetting.LightSamples(16));
        robot.interact(() -> table().getSelectionModel().selectFirst());
        click("use-setting");
        assertThat(model().editor().scene().lights()).allMatch(light -> light.area().samples() == 4);
    }

    private boolean isMarked(String id, String state) {
        return robot.lookup("#" + id).<Node>query().getPseudoClassStates().contains(PseudoClass.getPseudoClass(state));
    }
}
