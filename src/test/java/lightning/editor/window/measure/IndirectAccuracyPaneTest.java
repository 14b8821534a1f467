package lightning.editor.window.measure;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.scene.control.TableView;
import lightning.bench.accuracy.IndirectSweep;
import lightning.editor.document.Command;
import lightning.editor.window.EditorFixture;
import lightning.scene.IndirectSettings;
import org.junit.jupiter.api.Test;

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
}
