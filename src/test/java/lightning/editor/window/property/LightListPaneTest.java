package lightning.editor.window.property;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import javafx.css.PseudoClass;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.control.TextField;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.KeyCode;
import javafx.stage.Stage;
import lightning.base.math.Vec3;
import lightning.document.LightEdits;
import lightning.editor.Command;
import lightning.editor.window.JavaFxRequirement;
import lightning.editor.window.StageExtension;
import lightning.editor.window.TestEditors;
import lightning.editor.window.model.EditorModel;
import lightning.sample.Slow;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import org.testfx.framework.junit5.Stop;

@ExtendWith({JavaFxRequirement.class, StageExtension.class})
@Slow
class LightListPaneTest {
    @TempDir
    private Path folder;
    private EditorModel model;

    @Start
    private void start(Stage stage) throws Exception {
        model = TestEditors.model(folder);
        TestEditors.show(stage, new LightListPane(model.editor(), model.commands()));
    }

    @Stop
    private void stop() {
        model.close();
    }

    @Test
    void lights_areListedInOrder(FxRobot robot) {
        assertThat(names(robot)).containsExactly("key", "fill", "sun");
        assertThat(selected(robot)).isEqualTo("key");
    }

    @Test
    void click_selectsTheLight(FxRobot robot) {
        robot.clickOn("sun");
        assertThat(model.editor().selection().light().name()).isEqualTo("sun");
    }

    @Test
    void arrowKeys_selectTheNextLight(FxRobot robot) {
        robot.clickOn("key").push(KeyCode.DOWN);
        assertThat(model.editor().selection().light().name()).isEqualTo("fill");
    }

    @Test
    void lightSelectedInEditor_isSelectedInList(FxRobot robot) {
        robot.interact(() -> model.editor().selection().selectLight("fill"));
        assertThat(selected(robot)).isEqualTo("fill");
        robot.interact(() -> model.editor().selection().selectLight(null));
        assertThat(list(robot).getSelectionModel().isEmpty()).isTrue();
    }

    @Test
    void addLight_addsTypeAndSelectsIt(FxRobot robot) {
        robot.clickOn("#add-light").clickOn("Spot");
        assertThat(names(robot)).containsExactly("key", "fill", "sun", "spot");
        assertThat(model.editor().selection().light().type()).isEqualTo(LightType.SPOT);
        assertThat(selected(robot)).isEqualTo("spot");
    }

    @Test
    void duplicate_insertsCopyAfterAndSelectsIt(FxRobot robot) {
        robot.clickOn("#duplicate-light");
        assertThat(names(robot)).containsExactly("key", "key2", "fill", "sun");
        assertThat(model.editor().selection().light().name()).isEqualTo("key2");
        assertThat(model.editor().selection().light().position()).isEqualTo(new Vec3(3.9, 5, 2));
        assertThat(model.editor().message().textProperty().get()).isEqualTo("Duplicated key as key2, offset by 0.9 along x");
    }

    @Test
    void deleteKey_deletesTheSelectedLight(FxRobot robot) {
        robot.clickOn("fill").push(KeyCode.DELETE);
        assertThat(names(robot)).containsExactly("key", "sun");
        assertThat(selected(robot)).isEqualTo("sun");
        robot.push(KeyCode.DELETE);
        assertThat(selected(robot)).isEqualTo("key");
    }

    @Test
    void deletedLight_afterUndo_isSelected(FxRobot robot) {
        robot.clickOn("fill").clickOn("#delete-light");
        robot.interact(() -> model.commands().run(Command.UNDO));
        assertThat(names(robot)).containsExactly("key", "fill", "sun");
        assertThat(selected(robot)).isEqualTo("fill");
    }

    @Test
    void bulb_switchesItsLightWithoutSelectingIt(FxRobot robot) {
        robot.clickOn(toggle(robot, "sun on"));
        assertThat(TestEditors.light(model, "sun").on()).isFalse();
        assertThat(model.editor().selection().light().name()).isEqualTo("key");
        robot.clickOn(toggle(robot, "sun on"));
        assertThat(TestEditors.light(model, "sun").on()).isTrue();
    }

    @Test
    void soloLight_darkensTheOthers(FxRobot robot) {
        robot.clickOn(toggle(robot, "fill solo"));
        assertThat(TestEditors.light(model, "fill").solo()).isTrue();
        assertThat(robot.lookup(".light-row").queryAllAs(Node.class).stream()
                .filter(row -> row.getPseudoClassStates().contains(PseudoClass.getPseudoClass("dark")))).hasSize(2);
    }

    @Test
    void spaceAndS_switchTheSelectedLight(FxRobot robot) {
        robot.clickOn("sun").push(KeyCode.SPACE).push(KeyCode.S);
        assertThat(TestEditors.light(model, "sun").on()).isFalse();
        assertThat(TestEditors.light(model, "sun").solo()).isTrue();
    }

    @Test
    void f2_renamesInPlace(FxRobot robot) {
        robot.clickOn("fill").push(KeyCode.F2).write("rim").push(KeyCode.ENTER);
        assertThat(names(robot)).containsExactly("key", "rim", "sun");
        assertThat(model.editor().selection().light().name()).isEqualTo("rim");
        assertThat(robot.lookup("rim").tryQuery()).isPresent();
    }

    @Test
    void nameWithSpacesAndSymbols_isAccepted(FxRobot robot) {
        robot.clickOn("fill").push(KeyCode.F2).write("_7 \"a=b\" Ä").push(KeyCode.ENTER);
        assertThat(names(robot)).containsExactly("key", "_7 \"a=b\" Ä", "sun");
        assertThat(robot.lookup("_7 \"a=b\" Ä").tryQuery()).isPresent();
        robot.interact(() -> model.editor().edit(scene -> LightEdits.duplicate(scene, "_7 \"a=b\" Ä")));
        assertThat(names(robot)).containsExactly("key", "_7 \"a=b\" Ä", "_7 \"a=b\" Ä2", "sun");
    }

    @Test
    void doubleClick_renamesInPlace(FxRobot robot) {
        robot.doubleClickOn("fill").write("rim").push(KeyCode.ENTER);
        assertThat(names(robot)).containsExactly("key", "rim", "sun");
    }

    @Test
    void secondClick_doesNotRename(FxRobot robot) {
        robot.clickOn("key").clickOn("#duplicate-light").clickOn("key2");
        assertThat(robot.lookup(".light-row .text-field").tryQuery()).isEmpty();
    }

    @Test
    void duplicateName_isRefused(FxRobot robot) {
        robot.clickOn("fill").push(KeyCode.F2).write("sun").push(KeyCode.ENTER);
        assertThat(names(robot)).containsExactly("key", "fill", "sun");
        TextField field = robot.lookup(".light-row .text-field").queryAs(TextField.class);
        assertThat(field.getPseudoClassStates()).contains(PseudoClass.getPseudoClass("refused"));
        assertThat(field.getAccessibleHelp()).contains("already taken");
        robot.push(KeyCode.ESCAPE);
        assertThat(robot.lookup(".light-row .text-field").tryQuery()).isEmpty();
        robot.push(KeyCode.F2).write("rim").push(KeyCode.ENTER);
        assertThat(names(robot)).containsExactly("key", "rim", "sun");
    }

    @Test
    void lightGroups_areListedAfterUngroupedLights(FxRobot robot) {
        robot.clickOn("key");
        robot.interact(() -> model.commands().run(Command.NEW_LIGHT_GROUP));
        assertThat(names(robot)).containsExactly("fill", "sun", "group", "key");
        assertThat(selected(robot)).isEqualTo("key");
        robot.interact(() -> model.commands().run(Command.DELETE_LIGHT_GROUP));
        assertThat(names(robot)).containsExactly("key", "fill", "sun");
        robot.interact(() -> model.commands().run(Command.UNDO));
        assertThat(names(robot)).containsExactly("fill", "sun", "group", "key");
    }

    @Test
    void collapsedGroup_hidesItsLights(FxRobot robot) {
        robot.interact(() -> model.commands().run(Command.NEW_LIGHT_GROUP));
        robot.clickOn(".group-row .fold");
        assertThat(names(robot)).containsExactly("fill", "sun", "group");
        robot.clickOn(".group-row .fold");
        assertThat(names(robot)).containsExactly("fill", "sun", "group", "key");
    }

    @Test
    void groupToggles_applyToAllItsLights(FxRobot robot) {
        robot.interact(() -> model.commands().run(Command.NEW_LIGHT_GROUP));
        robot.clickOn(toggle(robot, "group on"));
        assertThat(model.editor().scene().rig().lightGroup("group").orElseThrow().on()).isFalse();
        assertThat(model.editor().scene().isActive(TestEditors.light(model, "key"))).isFalse();
        robot.clickOn(toggle(robot, "group on")).clickOn(toggle(robot, "group solo"));
        assertThat(model.editor().scene().isActive(TestEditors.light(model, "sun"))).isFalse();
    }

    @Test
    void lightDroppedOnGroup_joinsIt(FxRobot robot) {
        robot.interact(() -> model.commands().run(Command.NEW_LIGHT_GROUP));
        robot.interact(() -> LightGroupDrop.moveLight("sun", "group", model.editor()));
        assertThat(names(robot)).containsExactly("fill", "group", "key", "sun");
        robot.interact(() -> LightGroupDrop.moveLight("key", "", model.editor()));
        assertThat(names(robot)).containsExactly("key", "fill", "group", "sun");
    }

    @Test
    void groupKeys_renameToggleAndDeleteIt(FxRobot robot) {
        robot.interact(() -> model.commands().run(Command.NEW_LIGHT_GROUP));
        robot.clickOn("group").push(KeyCode.F2).write("left").push(KeyCode.ENTER);
        assertThat(TestEditors.light(model, "key").lightGroup()).isEqualTo("left");
        robot.push(KeyCode.SPACE);
        assertThat(model.editor().scene().rig().lightGroup("left").orElseThrow().on()).isFalse();
        robot.push(KeyCode.DELETE);
        assertThat(names(robot)).containsExactly("key", "fill", "sun");
    }

    @Test
    void sceneWithoutLights_showsPlaceholder(FxRobot robot) {
        robot.interact(() -> model.editor().edit(scene -> LightEdits.delete(scene, "key")));
        robot.interact(() -> model.editor().edit(scene -> LightEdits.delete(scene, "fill")));
        robot.interact(() -> model.editor().edit(scene -> LightEdits.delete(scene, "sun")));
        assertThat(robot.lookup("No lights. Add one above.").tryQuery()).isPresent();
        assertThat(robot.lookup("#delete-light").query().isDisabled()).isTrue();
        assertThat(robot.lookup("#duplicate-light").query().isDisabled()).isTrue();
    }

    private static ListView<?> list(FxRobot robot) {
        return robot.lookup("#light-list").queryAs(ListView.class);
    }

    /** Returns the displayed names from top to bottom. */
    private static List<String> names(FxRobot robot) {
        return robot.lookup(".light-list .list-cell").<ListCell<?>>queryAllAs(cell()).stream().filter(c -> c.getGraphic() != null)
                .sorted(Comparator.comparing(ListCell::getIndex)).map(LightListPaneTest::name).toList();
    }

    @SuppressWarnings("unchecked")
    private static Class<ListCell<?>> cell() {
        return (Class<ListCell<?>>) (Class<?>) ListCell.class;
    }

    /** A field replaces the label while a light is renamed; screen readers still read the name. */
    private static String name(ListCell<?> cell) {
        return cell.lookup(".light-row .label") instanceof Label label ? label.getText() : cell.getAccessibleText().split(",")[0];
    }

    private static String selected(FxRobot robot) {
        return names(robot).get(list(robot).getSelectionModel().getSelectedIndex());
    }

    private static Node toggle(FxRobot robot, String name) {
        return robot.lookup(".light-row .toggle-button").queryAllAs(ToggleButton.class).stream()
                .filter(button -> name.equals(button.getAccessibleText())).findFirst().orElseThrow();
    }
}
