package lightning.editor.window.property;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;
import javafx.scene.control.CheckBox;
import javafx.scene.control.CustomMenuItem;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import lightning.editor.document.Change;
import lightning.editor.document.Command;
import lightning.editor.document.LightEdits;
import lightning.editor.window.EditorDesk;
import lightning.scene.Group;
import lightning.scene.Links;
import lightning.scene.Material;
import lightning.scene.Node;
import lightning.scene.Placement;
import lightning.scene.Shape;
import lightning.scene.Solid;
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
        assertThat(model().editor().selection().light().illuminates()).isEqualTo(Links.except(shape));
        assertThat(model().editor().selection().light().shadowedBy()).isEqualTo(Links.ALL);
        assertThat(menu("illuminates").getText()).isEqualTo("all but '" + shape + "'");
        robot.interact(() -> model().commands().run(Command.UNDO));
        assertThat(menu("illuminates").getText()).isEqualTo("all");
    }

    @Test
    void onlyTheChecked_throwShadows() {
        String shape = check("shadowed_by");
        MenuItem only = menu("shadowed_by").getItems().get(1);
        robot.interact(only::fire);
        assertThat(model().editor().selection().light().shadowedBy()).isEqualTo(Links.only(shape));
    }

    @Test
    void lightDroppedOnAShape_shinesOnItNoMore_andAgain() {
        robot.interact(() -> LinkDrop.drop("lamp", "ball", false, model().editor()));
        assertThat(light("lamp").illuminates()).isEqualTo(Links.except("ball"));
        assertThat(model().editor().message().textProperty().get()).isEqualTo("lamp does not shine on ball");
        assertThat(model().editor().situationProperty().get().undo()).contains("lamp: illuminates all → all but 'ball'");
        assertGoShowsTheScene();
        robot.interact(() -> LinkDrop.drop("lamp", "ball", false, model().editor()));
        assertThat(light("lamp").illuminates()).isEqualTo(Links.ALL);
        assertThat(model().editor().message().textProperty().get()).isEqualTo("lamp shines on ball");
    }

    @Test
    void lightDroppedOnAShapeWithCtrlAndShift_isShadowedByItNoMore() {
        robot.interact(() -> LinkDrop.drop("lamp", "ball", true, model().editor()));
        assertThat(light("lamp").shadowedBy()).isEqualTo(Links.except("ball"));
        assertThat(light("lamp").illuminates()).isEqualTo(Links.ALL);
        assertThat(model().editor().message().textProperty().get()).isEqualTo("ball throws no shadow in the light of lamp");
        assertGoShowsTheScene();
        click("undo");
        assertThat(light("lamp").shadowedBy()).isEqualTo(Links.ALL);
    }

    @Test
    void withoutALight_nothingCanBeLinked() {
        robot.interact(() -> model().editor().selection().selectLight(null));
        assertThat(menu("illuminates").isDisabled()).isTrue();
    }

    private List<String> offered(String id) {
        robot.interact(() -> menu(id).getOnShowing().handle(null));
        return menu(id).getItems().stream()
                .map(i -> i instanceof CustomMenuItem c ? c.getContent() instanceof CheckBox b ? b.getText() : null : i.getText())
                .filter(Objects::nonNull).toList();
    }

    private static Group group(String name, int shapes) {
        return new Group(name, Placement.IDENTITY, IntStream.range(0, shapes).<Node>mapToObj(i -> new Shape(Solid.SPHERE, name + "_" + i,
                Material.DEFAULT.name(), Placement.IDENTITY)).toList(), false);
    }

    @Test
    void whatStandsBehindManyShapesInAGroup_isOffered_andWhatIsLinkedAlready() {
        robot.interact(() -> model().editor().edit(scene -> Change.of(
                () -> scene.withNodes(List.of(group("many", 300), group("few", 3), group("others", 195))))));
        assertThat(offered("illuminates")).contains("many", "few", "few_2", "others").doesNotContain("many_0", "others_0")
                .last().isEqualTo("More can be named in the file");
        String light = model().editor().selection().light().name();
        robot.interact(
                () -> model().editor().edit(scene -> LightEdits.with(scene, light, l -> l.withIlluminates(Links.except("others_7")))));
        assertThat(offered("illuminates")).contains("others_7", "others_194").doesNotContain("few_2");
    }
}
