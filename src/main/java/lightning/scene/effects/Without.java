package lightning.scene.effects;

import java.util.List;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.scene.Group;
import lightning.scene.Light;
import lightning.scene.Material;
import lightning.scene.Node;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.Solid;

/** Scenes with something taken away. */
final class Without {
    private Without() {}

    static Scene materials(Scene s, UnaryOperator<Material> change) {
        return s.withMaterials(s.materials().stream().map(change).toList());
    }

    /** Nothing mirrors by its colour, and no ray is followed unless something is clear, which mirrors by its angle. */
    static Scene reflections(Scene s) {
        Scene matt = materials(s, m -> m.withReflective(Rgb.BLACK));
        return s.materials().stream().anyMatch(m -> m.clarity().isClear()) ? matt : matt.withPicture(s.picture().withDepth(0));
    }

    static Scene lights(Scene s, UnaryOperator<Light> change) {
        return s.withLights(s.lights().stream().map(change).toList());
    }

    /** The light as a point, or as one direction. */
    static Light area(Light light) {
        return light.withArea(light.area().withRadius(0).withSpread(0).withWidth(0).withHeight(0));
    }

    static Scene shapes(Scene s, Class<? extends Solid> type) {
        return s.withNodes(nodes(s.nodes(), shape -> type.isInstance(shape.solid()) ? Stream.empty() : Stream.of(shape)));
    }

    static Scene vertexColors(Scene s) {
        return s.withNodes(nodes(s.nodes(), shape -> Stream.of(shape.solid() instanceof Solid.Triangles t
                ? shape.withSolid(t.withColors(false)) : shape)));
    }

    /** Each shape becomes what {@code change} makes of it, in the same groups. */
    private static List<Node> nodes(List<Node> nodes, Function<Shape, Stream<Shape>> change) {
        return nodes.stream().<Node>flatMap(node -> switch (node) {
            case Group group -> Stream.of(group.withChildren(nodes(group.children(), change)));
            case Shape shape -> change.apply(shape);
        }).toList();
    }
}
