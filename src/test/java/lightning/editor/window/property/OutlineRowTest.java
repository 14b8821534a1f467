package lightning.editor.window.property;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import javafx.collections.FXCollections;
import javafx.collections.ListChangeListener;
import javafx.collections.ObservableList;
import lightning.scene.Stage;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

class OutlineRowTest {
    private final ObservableList<OutlineRow> lines = FXCollections.observableArrayList();
    private int changedLines;

    private static Shape sphere(String name) {
        return new Shape(Solid.SPHERE, name, Material.DEFAULT.name(), Placement.IDENTITY);
    }

    private static Stage stage(int shapes) {
        List<SceneNode> nodes = new ArrayList<>(IntStream.range(0, shapes).mapToObj(i -> sphere("s" + i)).toList());
        nodes.add(new NodeGroup("g", Placement.IDENTITY, List.of(sphere("in"), sphere("it")), true));
        return new Stage(List.of(), nodes);
    }

    private void show(Stage stage, String... unfolded) {
        OutlineRow.update(lines, stage, Set.of(unfolded));
        assertThat(lines).isEqualTo(OutlineRow.of(stage, Set.of(unfolded)));
    }

    private void countChanges() {
        lines.addListener((ListChangeListener<OutlineRow>) change -> {
            while (change.next()) {
                changedLines += change.getAddedSize() + change.getRemovedSize();
            }
        });
    }

    @Test
    void editsInExpandedGroup_changeOnlyLastLine() {
        Stage stage = stage(1000);
        show(stage, "g");
        countChanges();
        show(stage.replaceNode("in", List.of(sphere("other"))), "g");
        assertThat(changedLines).isZero();
        show(stage.replaceNode("in", List.of(sphere("in"), sphere("other"))), "g");
        assertThat(changedLines).isEqualTo(1);
        show(stage, "g");
        assertThat(changedLines).isEqualTo(2);
    }

    @Test
    void editOfOneShape_changesAtMostOneLine() {
        Stage stage = stage(1000);
        show(stage);
        countChanges();
        show(stage.replaceNode("s500", List.of(sphere("other"))));
        assertThat(changedLines).isZero();
        show(stage.replaceNode("s500", List.of(sphere("s500"), sphere("other"))));
        assertThat(changedLines).isEqualTo(1);
        show(stage);
        assertThat(changedLines).isEqualTo(2);
    }

    @Test
    void expandedGroups_listChildren_andRenameInPlace() {
        Stage stage = stage(2);
        show(stage);
        show(stage, "g");
        assertThat(lines).hasSize(5);
        show(stage.replaceNode("s0", List.of()), "g");
        show(stage, "g");
        show(stage);
        show(stage(5000));
        show(stage);
    }

    @Test
    void nodeLine_isFoundByItsIndices() {
        Stage stage = stage(3);
        show(stage, "g");
        for (String name : List.of("s0", "s2", "g", "in", "it")) {
            int line = OutlineRow.indexOf(lines, stage.path(name).orElseThrow());
            assertThat(lines.get(line).node(stage).name()).isEqualTo(name);
        }
        show(stage);
        assertThat(OutlineRow.indexOf(lines, stage.path("it").orElseThrow())).isNegative();
    }
}
