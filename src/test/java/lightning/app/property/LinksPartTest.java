package lightning.app.property;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.scene.control.CheckBox;
import javafx.scene.control.CustomMenuItem;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import lightning.app.EditorDesk;
import lightning.edit.Command;
import lightning.scene.Links;
import org.junit.jupiter.api.Test;

class LinksPartTest extends EditorDesk {
    private MenuButton menu(String id) {
        return robot.lookup("#" + id).query();
    }

    private String check(String id) {
        // The window that shows no screen has no room for a menu.
        robot.interact(() -> menu(id).getOnShowing().handle(null));
        CheckBox first = menu(id).getItems().stream().filter(CustomMenuItem.class::isInstance)
                .map(i -> ((CustomMenuItem) i).getContent()).filter(CheckBox.class::isInstance).map(CheckBox.class::cast).findFirst()
                .orElseThrow();
        robot.interact(first::fire);
        return first.getText();
    }

    @Test
    void checkedShape_isLeftOut_andUndone() {
        String shape = check("illuminates");
        assertThat(model().selectedLight().illuminates()).isEqualTo(Links.except(shape));
        assertThat(model().selectedLight().shadowedBy()).isEqualTo(Links.ALL);
        assertThat(menu("illuminates").getText()).isEqualTo("all but '" + shape + "'");
        robot.interact(() -> model().run(Command.UNDO));
        assertThat(menu("illuminates").getText()).isEqualTo("all");
    }

    @Test
    void onlyTheChecked_throwShadows() {
        String shape = check("shadowed_by");
        MenuItem only = menu("shadowed_by").getItems().get(1);
        robot.interact(only::fire);
        assertThat(model().selectedLight().shadowedBy()).isEqualTo(Links.only(shape));
    }

    @Test
    void withoutALight_nothingCanBeLinked() {
        robot.interact(() -> model().selectLight(null));
        assertThat(menu("illuminates").isDisabled()).isTrue();
    }
}
