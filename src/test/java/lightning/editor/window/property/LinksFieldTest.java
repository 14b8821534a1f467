package lightning.editor.window.property;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;
import javafx.scene.control.CheckBox;
import javafx.scene.control.CustomMenuItem;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import lightning.document.EditOutcome;
import lightning.document.LightEdits;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import lightning.scene.value.ShapeLinks;
import org.junit.jupiter.api.Test;

class LinksFieldTest extends EditorFixture {
    private MenuButton menu(String id) {
        return robot.lookup("#" + id).query();
    }

    private String check(String id) {
        // The headless window has no room for a menu.
        robot.interact(() -> menu(id).getOnShowing().handle(null));
        CheckBox first = menu(id).getItems().stream().filter(CustomMenuItem.class::isInstance)
                .map(i -> ((CustomMenuItem) i).getContent()).filter(CheckBox.class::isInstance).map(CheckBox.class::cast).findFirst()
                .orElseThrow();
        robot.interact(first::fire);
        return first.getText();
    }

    @Test
    void checkedShape_isExcluded_andUndone() {
        String shape = check("illuminates");
        assertThat(model().editor().selection().light().illuminates()).isEqualTo(ShapeLinks.except(shape));
        assertThat(model().editor().selection().light().shadowedBy()).isEqualTo(ShapeLinks.ALL);
        assertThat(menu("illuminates").getText()).isEqualTo("all except '" + shape + "'");
        robot.interact(() -> model().commands().run(Command.UNDO));
        assertThat(menu("illuminates").getText()).isEqualTo("all");
    }

    @Test
    void onlyChecked_castShadows() {
        String shape = check("shadowed_by");
        MenuItem only = menu("shadowed_by").getItems().get(1);
        robot.interact(only::fire);
        assertThat(model().editor().selection().light().shadowedBy()).isEqualTo(ShapeLinks.only(shape));
    }

    @Test
    void lightDroppedOnShape_togglesItsIllumination() {
        robot.interact(() -> LinkDrop.toggleLink("lamp", "ball", false, model().editor()));
        assertThat(light("lamp").illuminates()).isEqualTo(ShapeLinks.except("ball"));
        assertThat(model().editor().message().textProperty().get()).isEqualTo("lamp does not illuminate ball");
        assertThat(model().editor().editorStateProperty().get().undoLabel()).contains("lamp: illuminates all → all except 'ball'");
        assertGoShowsTheScene();
        robot.interact(() -> LinkDrop.toggleLink("lamp", "ball", false, model().editor()));
        assertThat(light("lamp").illuminates()).isEqualTo(ShapeLinks.ALL);
        assertThat(model().editor().message().textProperty().get()).isEqualTo("lamp illuminates ball");
    }

    @Test
    void lightDroppedOnShape_withCtrlAndShift_togglesItsShadow() {
        robot.interact(() -> LinkDrop.toggleLink("lamp", "ball", true, model().editor()));
        assertThat(light("lamp").shadowedBy()).isEqualTo(ShapeLinks.except("ball"));
        assertThat(light("lamp").illuminates()).isEqualTo(ShapeLinks.ALL);
        assertThat(model().editor().message().textProperty().get()).isEqualTo("ball casts no shadows from lamp");
        assertGoShowsTheScene();
        click("undo");
        assertThat(light("lamp").shadowedBy()).isEqualTo(ShapeLinks.ALL);
    }

    @Test
    void links_withoutLight_areDisabled() {
        robot.interact(() -> model().editor().selection().selectLight(null));
        assertThat(menu("illuminates").isDisabled()).isTrue();
    }

    private List<String> listedNames(String id) {
        robot.interact(() -> menu(id).getOnShowing().handle(null));
        return menu(id).getItems().stream()
                .map(i -> i instanceof CustomMenuItem c ? c.getContent() instanceof CheckBox b ? b.getText() : null : i.getText())
                .filter(Objects::nonNull).toList();
    }

    private static NodeGroup group(String name, int shapes) {
        return new NodeGroup(name, Placement.IDENTITY,
                IntStream.range(0, shapes).<SceneNode>mapToObj(i -> new Shape(Solid.SPHERE, name + "_" + i,
                        Material.DEFAULT.name(), Placement.IDENTITY)).toList(),
                false);
    }

    @Test
    void menu_afterLargeGroup_listsOtherShapes_andLinkedOnes() {
        robot.interact(() -> model().editor().edit(scene -> EditOutcome.of(
                () -> scene.withNodes(List.of(group("many", 300), group("few", 3), group("others", 195))))));
        assertThat(listedNames("illuminates")).contains("many", "few", "few_2", "others").doesNotContain("many_0", "others_0")
                .last().isEqualTo("Link further objects in the scene file");
        String light = model().editor().selection().light().name();
        robot.interact(
                () -> model().editor().edit(scene -> LightEdits.edit(scene, light, l -> l.withIlluminates(ShapeLinks.except("others_7")))));
        assertThat(listedNames("illuminates")).contains("others_7", "others_194").doesNotContain("few_2");
    }
}
