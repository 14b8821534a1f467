package lightning.editor.window.property;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import javafx.collections.FXCollections;
import javafx.collections.ListChangeListener;
import javafx.collections.ObservableList;
import lightning.scene.Group;
import lightning.scene.Material;
import lightning.scene.Node;
import lightning.scene.Placement;
import lightning.scene.Shape;
import lightning.scene.Solid;
import lightning.scene.Stage;
import org.junit.jupiter.api.Test;

class OutlineRowTest {
    private final ObservableList<OutlineRow> lines = FXCollections.observableArrayList();
    private int touched;

    private static Shape sphere(String name) {
        return new Shape(Solid.SPHERE, name, Material.DEFAULT.name(), Placement.IDENTITY);
    }

    private static Stage stage(int shapes) {
        List<Node> nodes = new ArrayList<>(IntStream.range(0, shapes).mapToObj(i -> sphere("s" + i)).toList());
        nodes.add(new Group("g", Placement.IDENTITY, List.of(sphere("in"), sphere("it")), true));
        return new Stage(List.of(), nodes);
    }

    private void show(Stage stage, String... unfolded) {
        OutlineRow.update(lines, stage, Set.of(unfolded));
        assertThat(lines).isEqualTo(OutlineRow.of(stage, Set.of(unfolded)));
    }

    private void countTouched() {
        lines.addListener((ListChangeListener<OutlineRow>) change -> {
            while (change.next()) {
                touched += change.getAddedSize() + change.getRemovedSize();
            }
        });
    }

    @Test
    void editsInsideOfAnUnfoldedGroup_touchItsLastLineAlone() {
        Stage stage = stage(1000);
        show(stage, "g");
        countTouched();
        show(stage.replacing("in", List.of(sphere("other"))), "g");
        assertThat(touched).isZero();
        show(stage.replacing("in", List.of(sphere("in"), sphere("other"))), "g");
        assertThat(touched).isEqualTo(1);
        show(stage, "g");
        assertThat(touched).isEqualTo(2);
    }

    @Test
    void editsOfOneOfManyShapes_touchOneLineAtMost() {
        Stage stage = stage(1000);
        show(stage);
        countTouched();
        show(stage.replacing("s500", List.of(sphere("other"))));
        assertThat(touched).isZero();
        show(stage.replacing("s500", List.of(sphere("s500"), sphere("other"))));
        assertThat(touched).isEqualTo(1);
        show(stage);
        assertThat(touched).isEqualTo(2);
    }

    @Test
    void groupsThatAreUnfolded_areListedWithWhatIsInThem_andRenamedInPlace() {
        Stage stage = stage(2);
        show(stage);
        show(stage, "g");
        assertThat(lines).hasSize(5);
        show(stage.replacing("s0", List.of()), "g");
        show(stage, "g");
        show(stage);
        show(stage(5000));
        show(stage);
    }

    @Test
    void lineOfANode_isFoundByItsPlaces() {
        Stage stage = stage(3);
        show(stage, "g");
        for (String name : List.of("s0", "s2", "g", "in", "it")) {
            int line = OutlineRow.line(lines, stage.places(name).orElseThrow());
            assertThat(lines.get(line).node(stage).name()).isEqualTo(name);
        }
        show(stage);
        assertThat(OutlineRow.line(lines, stage.places("it").orElseThrow())).isNegative();
    }
}
