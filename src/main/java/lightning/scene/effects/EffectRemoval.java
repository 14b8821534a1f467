package lightning.scene.effects;

import java.util.List;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;

/** Scenes with an effect removed. */
final class EffectRemoval {
    private EffectRemoval() {}

    static Scene mapMaterials(Scene s, UnaryOperator<Material> change) {
        return s.withMaterials(s.materials().stream().map(change).toList());
    }

    /** Removes reflective colors, and ray depth unless a material is clear, which reflects by angle. */
    static Scene removeReflections(Scene s) {
        Scene nonReflective = mapMaterials(s, m -> m.withReflective(Rgb.BLACK));
        return s.materials().stream().anyMatch(Material::isClear) ? nonReflective
                : nonReflective.withPicture(s.picture().withDepth(0));
    }

    static Scene mapLights(Scene s, UnaryOperator<Light> change) {
        return s.withLights(s.lights().stream().map(change).toList());
    }

    /**
     * Returns the light as a point or as a single direction. Keeps its size, which decides its face and the brightness of a light in nits,
     * and the texture of the face.
     */
    static Light removeArea(Light light) {
        return light.isArea() ? light.withArea(light.area().withHardShadows(true)) : light;
    }

    static Scene removeShapes(Scene s, Class<? extends Solid> type) {
        return s.withNodes(mapNodes(s.nodes(), shape -> type.isInstance(shape.solid()) ? Stream.empty() : Stream.of(shape)));
    }

    static Scene removeVertexColors(Scene s) {
        return s.withNodes(mapNodes(s.nodes(), shape -> Stream.of(shape.solid() instanceof Solid.TriangleMesh t
                ? shape.withSolid(t.withShowsColors(false)) : shape)));
    }

    /** Replaces each shape by the result of {@code change}, in the same groups. */
    private static List<SceneNode> mapNodes(List<SceneNode> nodes, Function<Shape, Stream<Shape>> change) {
        return nodes.stream().<SceneNode>flatMap(node -> switch (node) {
            case NodeGroup group -> Stream.of(group.withChildren(mapNodes(group.children(), change)));
            case Shape shape -> change.apply(shape);
        }).toList();
    }
}
