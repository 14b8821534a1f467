package lightning.editor.window.traced;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.RadioMenuItem;
import lightning.editor.window.EditorFixture;
import org.junit.jupiter.api.Test;

class ReflectionMenuTest extends EditorFixture {

    private RadioMenuItem item(int rays) {
        List<MenuItem> items = robot.lookup("#traced-sizes").<MenuButton>query().getItems();
        return (RadioMenuItem) all(items).filter(i -> ("reflection-rays-" + rays).equals(i.getId())).findFirst().orElseThrow();
    }

    private static Stream<MenuItem> all(List<MenuItem> items) {
        return items.stream().flatMap(i -> i instanceof Menu menu ? all(menu.getItems()) : Stream.of(i));
    }

    @Test
    void rays_areChosenShownAndUndone() {
        assertThat(item(16).isSelected()).isTrue();
        robot.interact(item(64)::fire);
        assertThat(model().editor().scene().picture().reflectionRays()).isEqualTo(64);
        assertThat(item(64).isSelected()).isTrue();
        assertThat(item(16).isSelected()).isFalse();
        assertThat(model().editor().editorStateProperty().get().undoLabel()).contains("reflection rays 16 → 64");
        click("undo");
        assertThat(item(16).isSelected()).isTrue();
    }
}
