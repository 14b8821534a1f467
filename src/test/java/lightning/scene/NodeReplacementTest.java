package lightning.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lightning.sample.IndirectArbitraries;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

/** Compares incremental replacement of nodes with a stage built from scratch. */
class NodeReplacementTest {
    enum Replacement {
        NOTHING,
        ITSELF_HIDDEN,
        ITSELF_RENAMED,
        ITSELF_AND_A_COPY,
        ITS_CONTENT,
        A_GROUP_WITH_IT,
        ANOTHER_MATERIAL
    }

    @Provide
    Arbitrary<Scene> scenes() {
        return IndirectArbitraries.mixedScenes();
    }

    private static List<? extends SceneNode> of(SceneNode node, Replacement kind) {
        return switch (kind) {
            case NOTHING -> List.of();
            case ITSELF_HIDDEN -> List.of(node.withVisible(!node.visible()));
            case ITSELF_RENAMED -> List.of(rename(node, "other"));
            case ITSELF_AND_A_COPY -> List.of(node, rename(node, "other"));
            case ITS_CONTENT -> node instanceof NodeGroup g ? g.children() : List.of(node);
            case A_GROUP_WITH_IT -> List.of(new NodeGroup("around", Placement.IDENTITY, List.of(node)));
            case ANOTHER_MATERIAL -> List.of(node instanceof Shape s ? s.withMaterial(Material.DEFAULT.name()) : node);
        };
    }

    /** Renames a node and removes its children, whose names would conflict. */
    private static SceneNode rename(SceneNode node, String name) {
        return switch (node) {
            case NodeGroup g -> new NodeGroup(name, g.placement(), List.of(), g.visible());
            case Shape s -> s.withName(name);
        };
    }

    private static List<SceneNode> replaceNaively(List<SceneNode> nodes, String name, List<? extends SceneNode> replacement) {
        List<SceneNode> result = new ArrayList<>();
        for (SceneNode node : nodes) {
            if (node.name().equals(name)) {
                result.addAll(replacement);
            } else {
                result.add(node instanceof NodeGroup g ? g.withChildren(replaceNaively(g.children(), name, replacement)) : node);
            }
        }
        return result;
    }

    private static List<SceneNode> all(List<SceneNode> nodes) {
        List<SceneNode> all = new ArrayList<>();
        for (SceneNode node : nodes) {
            all.add(node);
            all.addAll(node instanceof NodeGroup g ? all(g.children()) : List.of());
        }
        return all;
    }

    /** Returns an outline with shapes as dots and groups by name. */
    private static String outline(List<SceneNode> nodes) {
        return nodes.stream().map(node -> switch (node) {
            case NodeGroup g -> "'" + g.name() + "'" + outline(g.children());
            case Shape _ -> ".";
        }).collect(Collectors.joining(" ", "(", ")"));
    }

    @Property
    void replacedNode_matchesNewStage(@ForAll("scenes") Scene scene, @ForAll int index, @ForAll Replacement kind) {
        List<SceneNode> nodes = all(scene.nodes());
        Assume.that(!nodes.isEmpty() && !scene.isNameUsed("other") && !scene.isNameUsed("around"));
        SceneNode node = nodes.get(Math.floorMod(index, nodes.size()));
        Stage stage = scene.stage().replaceNode(node.name(), of(node, kind));
        Stage read = new Stage(scene.materials(), replaceNaively(scene.nodes(), node.name(), of(node, kind)));
        assertThat(stage.withFaces(scene.rig())).isEqualTo(read.withFaces(scene.rig()));
        assertThat(stage.shapes()).isEqualTo(read.shapes());
        assertThat(stage.shapeCount()).isEqualTo(read.shapeCount());
        assertThat(List.copyOf(stage.usedMaterials())).isEqualTo(List.copyOf(read.usedMaterials()));
        nodes.addAll(all(stage.nodes()));
        assertThat(nodes).allSatisfy(n -> assertThat(stage.hasNode(n.name())).as(n.name()).isEqualTo(read.hasNode(n.name())));
        assertThat(stage.sharesStructure(scene.stage())).isEqualTo(outline(stage.nodes()).equals(outline(scene.nodes())));
    }

    private static Shape sphere(String name) {
        return new Shape(Solid.SPHERE, name, Material.DEFAULT.name(), Placement.IDENTITY);
    }

    private static final Stage STAGE = new Stage(List.of(), List.of(sphere("a"), sphere("b"), sphere("c")));

    @Test
    void duplicateName_isRejected() {
        for (String duplicate : List.of("a", "c")) {
            assertThatIllegalArgumentException().isThrownBy(() -> STAGE.replaceNode("b", List.of(sphere(duplicate))))
                    .withMessage("object '%s': the name is already taken", duplicate);
        }
        assertThatIllegalArgumentException().isThrownBy(() -> STAGE.replaceNode("b", List.of(sphere("d"), sphere("d"))))
                .withMessage("object 'd': the name is already taken");
    }

    @Test
    void combinedScaleBeyondRange_isRejected() {
        var small = new Placement(lightning.base.math.Vec3.ZERO, lightning.base.math.Vec3.ZERO,
                lightning.base.math.Vec3.ONE.times(SceneLimits.MIN_SCALE));
        Stage stage = new Stage(List.of(), List.of(new NodeGroup("g", small, List.of(sphere("a")))));
        assertThatIllegalArgumentException().isThrownBy(() -> stage.replaceNode("a", List.of(sphere("a").withPlacement(small))))
                .withMessageStartingWith("shape 'a'");
    }

    @Test
    void unknownName_isIgnored() {
        assertThat(STAGE.replaceNode("d", List.of())).isSameAs(STAGE);
    }

    @Test
    void repeatedEdits_searchOnce() {
        Stage stage = new Stage(List.of(), IntStream.range(0, 1000).<SceneNode>mapToObj(i -> sphere("s" + i)).toList());
        stage.node("s500");
        assertThat(stage.visitedNodes()).isGreaterThanOrEqualTo(500);
        for (List<? extends SceneNode> replacement : List.<List<? extends SceneNode>>of(List.of(sphere("s500").withVisible(false)),
                List.of(sphere("other")),
                List.of(sphere("s500"), sphere("other")), List.of())) {
            Stage edited = stage.replaceNode("s500", replacement);
            replacement.forEach(node -> assertThat(edited.node(node.name())).contains(node));
            assertThat(edited.node("s501")).contains(sphere("s501"));
            assertThat(edited.visitedNodes()).isLessThan(10);
        }
    }

    @Test
    void editsAmongManyShapes_matchNewStage() {
        List<SceneNode> inside = IntStream.range(0, 700).<SceneNode>mapToObj(i -> sphere("in" + i)).toList();
        List<SceneNode> nodes = new ArrayList<>(IntStream.range(0, 1500).<SceneNode>mapToObj(i -> sphere("s" + i)).toList());
        nodes.add(800, new NodeGroup("g", Placement.IDENTITY, inside));
        Stage stage = new Stage(List.of(), nodes);
        for (String name : List.of("s0", "s799", "g", "s1499", "in0", "in699")) {
            for (Replacement kind : Replacement.values()) {
                SceneNode node = stage.node(name).orElseThrow();
                Stage edited = stage.replaceNode(name, of(node, kind));
                List<SceneNode> plain = replaceNaively(nodes, name, of(node, kind));
                assertThat(edited.nodes()).isEqualTo(plain);
                assertThat(edited).isEqualTo(new Stage(List.of(), plain));
                List<String> names = all(plain).stream().map(SceneNode::name).toList();
                assertThat(names).allMatch(edited::hasNode);
                assertThat(all(nodes)).allMatch(n -> edited.hasNode(n.name()) == names.contains(n.name()));
                assertThatIllegalArgumentException().isThrownBy(() -> edited.replaceNode("s5", List.of(sphere("s5"), sphere("s6"))))
                        .withMessage("object 's6': the name is already taken");
            }
        }
    }
}
