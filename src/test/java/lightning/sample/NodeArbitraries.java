package lightning.sample;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Vec3;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Tuple;

/**
 * Arbitrary shapes of all kinds under arbitrary transforms, alone and in groups. Most are within 2 units of the origin, over a floor at y =
 * −1 that extends 7 units in each direction.
 */
final class NodeArbitraries {
    /** Material names for shapes; {@code default} is the scene's own. */
    static final List<String> MATERIALS = List.of("m0", "m1", "m2", "default");

    private NodeArbitraries() {}

    /** Returns a floor in most cases, possibly an enclosing shell, and up to eight more nodes. */
    static Arbitrary<List<SceneNode>> nodes() {
        Arbitrary<List<SceneNode>> free = Arbitraries.frequencyOf(Tuple.of(5, shapes()), Tuple.of(1, groups()))
                .list().ofMinSize(0).ofMaxSize(8);
        return Combinators.combine(free, Arbitraries.of(false, false, true), Arbitraries.of(false, true, true, true, true),
                Arbitraries.of(MATERIALS), Arbitraries.of(MATERIALS)).as(NodeArbitraries::assemble);
    }

    private static List<SceneNode> assemble(List<SceneNode> free, boolean shell, boolean floor, String floorMaterial,
            String shellMaterial) {
        List<SceneNode> nodes = new ArrayList<>();
        if (floor) {
            nodes.add(new Shape(Solid.PLANE, "floor", floorMaterial, placement(new Vec3(0, -1, 0), new Vec3(14, 1, 14))));
        }
        if (shell) {
            nodes.add(new Shape(Solid.SPHERE, "shell", shellMaterial, placement(Vec3.ZERO, new Vec3(12, 11, 13))));
        }
        for (SceneNode node : free) {
            nodes.add(withName(node, "n" + nodes.size()));
        }
        return nodes;
    }

    private static Placement placement(Vec3 at, Vec3 scale) {
        return new Placement(at, Vec3.ZERO, scale);
    }

    /** Returns a node with another name; the children of a group get names derived from it. */
    static SceneNode withName(SceneNode node, String name) {
        return switch (node) {
            case Shape s -> s.withName(name);
            case NodeGroup g -> {
                List<SceneNode> children = new ArrayList<>();
                for (SceneNode child : g.children()) {
                    children.add(withName(child, name + "_" + children.size()));
                }
                yield new NodeGroup(name, g.placement(), children, g.visible());
            }
        };
    }

    private static Arbitrary<SceneNode> shapes() {
        return Combinators.combine(SolidArbitraries.solids(), Arbitraries.of(MATERIALS), placements(), visible())
                .as((solid, material, placement, visible) -> new Shape(solid, "n", material, placement, visible));
    }

    private static Arbitrary<SceneNode> groups() {
        return Combinators.combine(placements(), shapes().list().ofMinSize(0).ofMaxSize(3), visible())
                .as((placement, children, visible) -> {
                    List<SceneNode> inner = new ArrayList<>();
                    children.forEach(c -> inner.add(withName(c, "n" + inner.size())));
                    return new NodeGroup("n", placement, inner, visible);
                });
    }

    private static Arbitrary<Boolean> visible() {
        return Arbitraries.frequency(Tuple.of(9, true), Tuple.of(1, false));
    }

    /** Returns moves and rotations of every size, from invisible to out of the image. */
    static Arbitrary<NodeChange> changes() {
        Arbitrary<Double> step = Arbitraries.oneOf(List.of(NumberArbitraries.range(-2, 2), Arbitraries.of(0.0, 1e-12, 1e-3, -50.0, 1e3)));
        return Arbitraries.frequencyOf(
                Tuple.of(5, NumberArbitraries.vectors(step, step, step).map(NodeChange.Move::new)),
                Tuple.of(2, rotations().map(NodeChange.Turn::new)),
                Tuple.of(2, scales().map(NodeChange.Scale::new)),
                Tuple.of(4, Arbitraries.of(new NodeChange.ToggleVisible())),
                Tuple.of(2, Arbitraries.of(new NodeChange.ToggleVertexColors())),
                Tuple.of(2, Arbitraries.of(MATERIALS).map(NodeChange.AssignMaterial::new)),
                Tuple.of(1, SolidArbitraries.solids().map(NodeChange.ReplaceSolid::new)));
    }

    private static Arbitrary<Placement> placements() {
        return Combinators.combine(
                NumberArbitraries.vectors(NumberArbitraries.range(-2, 2), NumberArbitraries.range(-1, 2), NumberArbitraries.range(-2, 2)),
                rotations(), scales()).as(Placement::new);
    }

    private static Arbitrary<Vec3> rotations() {
        Arbitrary<Double> angle = NumberArbitraries.rangeOrSpecial(-360, 360, 0.0, 90.0, 180.0, 1e6);
        return Arbitraries.frequencyOf(Tuple.of(1, Arbitraries.of(Vec3.ZERO)), Tuple.of(3, NumberArbitraries.vectors(angle, angle, angle)));
    }

    private static Arbitrary<Vec3> scales() {
        Arbitrary<Double> ordinary = NumberArbitraries.range(0.3, 1.5);
        Arbitrary<Double> extreme = Arbitraries.of(1e-3, -1.0, 1e-2, 50.0, 1e3);
        return Arbitraries.frequencyOf(
                Tuple.of(3, ordinary.map(s -> new Vec3(s, s, s))),
                Tuple.of(6, NumberArbitraries.vectors(ordinary, ordinary, ordinary)),
                Tuple.of(1, NumberArbitraries.vectors(extreme, ordinary, ordinary)),
                Tuple.of(1, NumberArbitraries.vectors(ordinary, extreme, extreme)));
    }
}
