package lightning.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lightning.sample.SceneArbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

/** What a stage knows of the nodes that were put in place of one is what it would find out of them all. */
class StageReplacingTest {
    enum By {
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
        return SceneArbitraries.scenes();
    }

    private static List<? extends Node> of(Node node, By by) {
        return switch (by) {
            case NOTHING -> List.of();
            case ITSELF_HIDDEN -> List.of(node.withVisible(!node.visible()));
            case ITSELF_RENAMED -> List.of(renamed(node, "other"));
            case ITSELF_AND_A_COPY -> List.of(node, renamed(node, "other"));
            case ITS_CONTENT -> node instanceof Group g ? g.children() : List.of(node);
            case A_GROUP_WITH_IT -> List.of(new Group("around", Placement.IDENTITY, List.of(node)));
            case ANOTHER_MATERIAL -> List.of(node instanceof Shape s ? s.withMaterial(Material.DEFAULT.name()) : node);
        };
    }

    /** With no content, whose names would be taken. */
    private static Node renamed(Node node, String name) {
        return switch (node) {
            case Group g -> new Group(name, g.placement(), List.of(), g.visible());
            case Shape s -> s.withName(name);
        };
    }

    private static List<Node> plainly(List<Node> nodes, String name, List<? extends Node> by) {
        List<Node> all = new ArrayList<>();
        for (Node node : nodes) {
            if (node.name().equals(name)) {
                all.addAll(by);
            } else {
                all.add(node instanceof Group g ? g.withChildren(plainly(g.children(), name, by)) : node);
            }
        }
        return all;
    }

    private static List<Node> all(List<Node> nodes) {
        List<Node> all = new ArrayList<>();
        for (Node node : nodes) {
            all.add(node);
            all.addAll(node instanceof Group g ? all(g.children()) : List.of());
        }
        return all;
    }

    /** Shapes as dots, groups with their names. */
    private static String outline(List<Node> nodes) {
        return nodes.stream().map(node -> switch (node) {
            case Group g -> "'" + g.name() + "'" + outline(g.children());
            case Shape _ -> ".";
        }).collect(Collectors.joining(" ", "(", ")"));
    }

    @Property
    void nodesInPlaceOfOne_areAsIfAllHadBeenRead(@ForAll("scenes") Scene scene, @ForAll int index, @ForAll By by) {
        List<Node> nodes = all(scene.nodes());
        Assume.that(!nodes.isEmpty() && !scene.isTaken("other") && !scene.isTaken("around"));
        Node node = nodes.get(Math.floorMod(index, nodes.size()));
        Stage stage = scene.stage().replacing(node.name(), of(node, by));
        Stage read = new Stage(scene.materials(), plainly(scene.nodes(), node.name(), of(node, by)));
        assertThat(stage).isEqualTo(read);
        assertThat(stage.shapes()).isEqualTo(read.shapes());
        assertThat(stage.shapeCount()).isEqualTo(read.shapeCount());
        assertThat(List.copyOf(stage.namedMaterials())).isEqualTo(List.copyOf(read.namedMaterials()));
        nodes.addAll(all(stage.nodes()));
        assertThat(nodes).allSatisfy(n -> assertThat(stage.hasNode(n.name())).as(n.name()).isEqualTo(read.hasNode(n.name())));
        assertThat(stage.sharesOutlineWith(scene.stage())).isEqualTo(outline(stage.nodes()).equals(outline(scene.nodes())));
    }

    private static Shape sphere(String name) {
        return new Shape(Solid.SPHERE, name, Material.DEFAULT.name(), Placement.IDENTITY);
    }

    private static final Stage STAGE = new Stage(List.of(), List.of(sphere("a"), sphere("b"), sphere("c")));

    @Test
    void takenName_isRefused() {
        for (String taken : List.of("a", "c")) {
            assertThatIllegalArgumentException().isThrownBy(() -> STAGE.replacing("b", List.of(sphere(taken))))
                    .withMessage("shape '%s': the name is already taken", taken);
        }
        assertThatIllegalArgumentException().isThrownBy(() -> STAGE.replacing("b", List.of(sphere("d"), sphere("d"))))
                .withMessage("shape 'd': the name is already taken");
    }

    @Test
    void scalesThatMultiplyBeyondTheRange_areRefused() {
        var small = new Placement(lightning.base.math.Vec3.ZERO, lightning.base.math.Vec3.ZERO,
                lightning.base.math.Vec3.ONE.times(Limits.MIN_SCALE));
        Stage stage = new Stage(List.of(), List.of(new Group("g", small, List.of(sphere("a")))));
        assertThatIllegalArgumentException().isThrownBy(() -> stage.replacing("a", List.of(sphere("a").withPlacement(small))))
                .withMessageStartingWith("shape 'a'");
    }

    @Test
    void unknownName_changesNothing() {
        assertThat(STAGE.replacing("d", List.of())).isSameAs(STAGE);
    }

    @Test
    void editsOfOneOfManyShapes_lookForItOnce() {
        Stage stage = new Stage(List.of(), IntStream.range(0, 1000).<Node>mapToObj(i -> sphere("s" + i)).toList());
        stage.node("s500");
        assertThat(stage.looked()).isGreaterThanOrEqualTo(500);
        for (List<? extends Node> by : List.<List<? extends Node>>of(List.of(sphere("s500").withVisible(false)), List.of(sphere("other")),
                List.of(sphere("s500"), sphere("other")), List.of())) {
            Stage edited = stage.replacing("s500", by);
            by.forEach(node -> assertThat(edited.node(node.name())).contains(node));
            assertThat(edited.node("s501")).contains(sphere("s501"));
            assertThat(edited.looked()).isLessThan(10);
        }
    }

    @Test
    void editsAmongManyShapes_areAsIfAllHadBeenRead() {
        List<Node> inside = IntStream.range(0, 700).<Node>mapToObj(i -> sphere("in" + i)).toList();
        List<Node> nodes = new ArrayList<>(IntStream.range(0, 1500).<Node>mapToObj(i -> sphere("s" + i)).toList());
        nodes.add(800, new Group("g", Placement.IDENTITY, inside));
        Stage stage = new Stage(List.of(), nodes);
        for (String name : List.of("s0", "s799", "g", "s1499", "in0", "in699")) {
            for (By by : By.values()) {
                Node node = stage.node(name).orElseThrow();
                Stage edited = stage.replacing(name, of(node, by));
                List<Node> plain = plainly(nodes, name, of(node, by));
                assertThat(edited.nodes()).isEqualTo(plain);
                assertThat(edited).isEqualTo(new Stage(List.of(), plain));
                List<String> names = all(plain).stream().map(Node::name).toList();
                assertThat(names).allMatch(edited::hasNode);
                assertThat(all(nodes)).allMatch(n -> edited.hasNode(n.name()) == names.contains(n.name()));
                assertThatIllegalArgumentException().isThrownBy(() -> edited.replacing("s5", List.of(sphere("s5"), sphere("s6"))))
                        .withMessage("shape 's6': the name is already taken");
            }
        }
    }
}
