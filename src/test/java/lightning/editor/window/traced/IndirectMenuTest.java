package lightning.editor.window.traced;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.scene.control.Button;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.RadioMenuItem;
import lightning.document.AttributeNumber;
import lightning.editor.window.EditorFixture;
import lightning.scene.IndirectSettings;
import org.junit.jupiter.api.Test;

class IndirectMenuTest extends EditorFixture {

    private RadioMenuItem item(String id) {
        List<MenuItem> items = robot.lookup("#traced-sizes").<MenuButton>query().getItems();
        return (RadioMenuItem) all(items).filter(i -> id.equals(i.getId())).findFirst().orElseThrow();
    }

    private static Stream<MenuItem> all(List<MenuItem> items) {
        return items.stream().flatMap(i -> i instanceof Menu menu ? all(menu.getItems()) : Stream.of(i));
    }

    private void choose(String id) {
        robot.interact(item(id)::fire);
    }

    private Optional<IndirectSettings> indirect() {
        return model().editor().scene().picture().indirect();
    }

    @Test
    void settings_areChosenShownAndUndone() {
        assertThat(item("indirect-off").isSelected()).isTrue();
        choose("indirect-on");
        choose("indirect-bounces-3");
        choose("indirect-rays-256");
        choose("indirect-spacing-4");
        choose("indirect-background-true");
        assertThat(indirect()).contains(new IndirectSettings(3, 256, 4, true));
        assertThat(Stream.of("on", "bounces-3", "rays-256", "spacing-4", "background-true"))
                .allMatch(id -> item("indirect-" + id).isSelected());
        assertThat(Stream.of("off", "bounces-2", "rays-64", "spacing-8", "background-false"))
                .noneMatch(id -> item("indirect-" + id).isSelected());
        assertThat(model().editor().editorStateProperty().get().undoLabel()).contains("indirect background off → on");
        click("undo");
        assertThat(indirect()).contains(new IndirectSettings(3, 256, 4, false));
        choose("indirect-off");
        assertThat(indirect()).isEmpty();
        click("undo");
        assertThat(indirect()).contains(new IndirectSettings(3, 256, 4, false));
    }

    @Test
    void settings_areEnabledWithIndirectLight() {
        assertThat(item("indirect-rays-64").isDisable()).isTrue();
        choose("indirect-on");
        assertThat(item("indirect-rays-64").isDisable()).isFalse();
        assertThat(indirect()).contains(IndirectSettings.INITIAL);
        choose("indirect-on");
        assertThat(indirect()).contains(IndirectSettings.INITIAL);
    }

    private Button warning() {
        return robot.lookup("#warning").query();
    }

    @Test
    void ambience_isReportedUntilItsCauseIsGone() {
        robot.interact(() -> model().editor().edit(scene -> AttributeNumber.AMBIENCE.set(scene, "", 0)));
        choose("indirect-on");
        assertThat(warning().isVisible()).isFalse();
        robot.interact(() -> model().editor().edit(scene -> AttributeNumber.AMBIENCE.set(scene, "", 1)));
        assertThat(warning().getText()).isEqualTo("ambience and indirect light count twice: set ambience to 0");
        robot.interact(() -> {
            model().editor().message().show("Saved");
            model().editor().go();
        });
        assertThat(warning().isVisible()).isTrue();
        choose("indirect-off");
        assertThat(warning().isVisible()).isFalse();
    }

    @Test
    void warning_isHiddenByAClick() {
        robot.interact(() -> model().editor().edit(scene -> AttributeNumber.AMBIENCE.set(scene, "", 1)));
        choose("indirect-on");
        click("warning");
        assertThat(warning().isVisible()).isFalse();
        choose("indirect-rays-256");
        assertThat(warning().isVisible()).isFalse();
        choose("indirect-off");
        choose("indirect-on");
        assertThat(warning().isVisible()).isTrue();
    }
}
