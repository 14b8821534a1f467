package lightning.app.property;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import javafx.scene.control.CheckBox;
import javafx.scene.control.CustomMenuItem;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.stage.Stage;
import lightning.app.JavaFxNeeds;
import lightning.app.OnStage;
import lightning.app.OpenEditor;
import lightning.app.model.EditorModel;
import lightning.edit.Command;
import lightning.scene.Links;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import org.testfx.framework.junit5.Stop;

@ExtendWith({JavaFxNeeds.class, OnStage.class})
class LinksPartTest {
    @TempDir
    private Path folder;
    private EditorModel model;

    @Start
    private void start(Stage stage) throws Exception {
        model = OpenEditor.model(folder);
        OpenEditor.show(stage, new PropertyPane(model));
    }

    @Stop
    private void stop() {
        model.close();
    }

    private static MenuButton menu(FxRobot robot, String id) {
        return robot.lookup("#" + id).queryAs(MenuButton.class);
    }

    private String check(FxRobot robot, String id) {
        // The window that shows no screen has no room for a menu.
        robot.interact(() -> menu(robot, id).getOnShowing().handle(null));
        CheckBox first = menu(robot, id).getItems().stream().filter(CustomMenuItem.class::isInstance)
                .map(i -> ((CustomMenuItem) i).getContent()).filter(CheckBox.class::isInstance).map(CheckBox.class::cast).findFirst()
                .orElseThrow();
        robot.interact(first::fire);
        return first.getText();
    }

    @Test
    void checkedShape_isLeftOut_andUndone(FxRobot robot) {
        String shape = check(robot, "illuminates");
        assertThat(model.selectedLight().illuminates()).isEqualTo(Links.except(shape));
        assertThat(model.selectedLight().shadowedBy()).isEqualTo(Links.ALL);
        assertThat(menu(robot, "illuminates").getText()).isEqualTo("all but '" + shape + "'");
        robot.interact(() -> model.run(Command.UNDO));
        assertThat(menu(robot, "illuminates").getText()).isEqualTo("all");
    }

    @Test
    void onlyTheChecked_throwShadows(FxRobot robot) {
        String shape = check(robot, "shadowed_by");
        MenuItem only = menu(robot, "shadowed_by").getItems().get(1);
        robot.interact(only::fire);
        assertThat(model.selectedLight().shadowedBy()).isEqualTo(Links.only(shape));
    }

    @Test
    void withoutALight_nothingCanBeLinked(FxRobot robot) {
        robot.interact(() -> model.selectLight(null));
        assertThat(menu(robot, "illuminates").isDisabled()).isTrue();
    }
}
