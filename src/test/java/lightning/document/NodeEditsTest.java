package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.World;
import lightning.scene.light.LightRig;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

class NodeEditsTest {
    private static Shape sphere(String name) {
        return new Shape(Solid.SPHERE, name, Material.DEFAULT.name(), Placement.IDENTITY);
    }

    private static Scene scene(SceneNode... nodes) {
        return new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT, new Stage(List.of(), List.of(nodes)), LightRig.EMPTY);
    }

    private static Scene sceneOf(EditOutcome change) {
        assertThat(change.refusal()).isEmpty();
        return ((EditOutcome.Applied) change).scene();
    }

    @Test
    void copy_hasTheNextFreeNumber() {
        assertThat(NodeEdits.copyName(scene(sphere("ball")), "ball")).isEqualTo("ball2");
        assertThat(NodeEdits.copyName(scene(sphere("ball"), sphere("ball2"), sphere("ball3")), "ball")).isEqualTo("ball4");
        assertThat(NodeEdits.copyName(scene(sphere("ball7")), "ball7")).isEqualTo("ball8");
    }

    @Test
    void copyAmongManyNumberedNames_hasFreeName() {
        Scene scene = scene(IntStream.rangeClosed(1, 1000).mapToObj(i -> sphere("tree" + i)).toArray(SceneNode[]::new));
        assertThat(NodeEdits.copyName(scene, "tree3")).isEqualTo("tree1001");
    }

    @Test
    void duplicatedGroup_isOffsetAndHasNewNames() {
        Scene scene = scene(new NodeGroup("g", Placement.IDENTITY, List.of(sphere("a"), sphere("a2"))));
        NodeGroup copy = (NodeGroup) sceneOf(NodeEdits.duplicate(scene, "g")).nodes().getLast();
        assertThat(copy.name()).isEqualTo("g2");
        assertThat(copy.children()).extracting(SceneNode::name).containsExactly("a3", "a4");
        assertThat(copy.placement().position().x()).isPositive();
        assertThat(copy.children().getFirst().placement()).as("children unmoved").isEqualTo(Placement.IDENTITY);
    }

    @Test
    void editOfMissingShape_isRefused() {
        assertThat(NodeEdits.setVisible(scene(), "ball", false).refusal()).contains("object 'ball' not found");
        assertThat(NodeEdits.delete(scene(), "ball").refusal()).contains("object 'ball' not found");
    }

    @Test
    void placementBeyondTheLimits_isRefused() {
        assertThat(
                NodeEdits.setPlacement(scene(sphere("ball")), "ball", p -> new Placement(p.position(), p.rotation(), Vec3.ZERO)).refusal())
                .hasValueSatisfying(reason -> assertThat(reason).startsWith("scale must be at least"));
    }
}
