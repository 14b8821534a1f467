package lightning.editor.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.Group;
import lightning.scene.Material;
import lightning.scene.Node;
import lightning.scene.Picture;
import lightning.scene.Placement;
import lightning.scene.Rig;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.Solid;
import lightning.scene.Stage;
import lightning.scene.World;
import org.junit.jupiter.api.Test;

class NodeEditsTest {
    private static Shape sphere(String name) {
        return new Shape(Solid.SPHERE, name, Material.DEFAULT.name(), Placement.IDENTITY);
    }

    private static Scene scene(Node... nodes) {
        return new Scene(Picture.DEFAULT, Camera.DEFAULT, World.DEFAULT, new Stage(List.of(), List.of(nodes)), Rig.DARK);
    }

    private static Scene done(Change change) {
        assertThat(change.refusal()).isEmpty();
        return ((Change.To) change).scene();
    }

    @Test
    void copy_hasTheNextFreeNumber() {
        assertThat(NodeEdits.copyOf(scene(sphere("ball")), "ball")).isEqualTo("ball2");
        assertThat(NodeEdits.copyOf(scene(sphere("ball"), sphere("ball2"), sphere("ball3")), "ball")).isEqualTo("ball4");
        assertThat(NodeEdits.copyOf(scene(sphere("ball7")), "ball7")).isEqualTo("ball8");
    }

    @Test
    void copyAmongManyThatAreNumbered_hasAFreeName() {
        Scene scene = scene(IntStream.rangeClosed(1, 1000).mapToObj(i -> sphere("tree" + i)).toArray(Node[]::new));
        assertThat(NodeEdits.copyOf(scene, "tree3")).isEqualTo("tree1001");
    }

    @Test
    void duplicatedGroup_standsBesideWithNewNames() {
        Scene scene = scene(new Group("g", Placement.IDENTITY, List.of(sphere("a"), sphere("a2"))));
        Group copy = (Group) done(NodeEdits.duplicate(scene, "g")).nodes().getLast();
        assertThat(copy.name()).isEqualTo("g2");
        assertThat(copy.children()).extracting(Node::name).containsExactly("a3", "a4");
        assertThat(copy.placement().at().x()).isPositive();
        assertThat(copy.children().getFirst().placement()).as("inside, nothing moved").isEqualTo(Placement.IDENTITY);
    }

    @Test
    void editOfAShapeThatIsGone_isRefused() {
        assertThat(NodeEdits.visible(scene(), "ball", false).refusal()).contains("there is no shape 'ball'");
        assertThat(NodeEdits.delete(scene(), "ball").refusal()).contains("there is no shape 'ball'");
    }

    @Test
    void placementBeyondTheLimits_isRefused() {
        assertThat(NodeEdits.placement(scene(sphere("ball")), "ball", p -> new Placement(p.at(), p.rotate(), Vec3.ZERO)).refusal())
                .hasValueSatisfying(reason -> assertThat(reason).startsWith("scale must be at least"));
    }
}
