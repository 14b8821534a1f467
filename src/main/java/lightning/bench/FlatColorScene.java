package lightning.bench;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.render.image.ViewTransform;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;

/**
 * Flat-color variant of a scene: a unique color per shape, without lights, reflections or textures. Programs with the same geometry render
 * the same image, except for pixels whose center is on an edge.
 */
final class FlatColorScene {
    /** Distance of two colors in display codes, well above rounding differences. */
    static final int STEP = 17;
    /** Codes per channel: 15, with black reserved for the background. */
    private static final int LEVELS = 255 / STEP;

    private final List<Material> materials = new ArrayList<>();

    private FlatColorScene() {}

    static Scene of(Scene scene) {
        FlatColorScene colors = new FlatColorScene();
        List<SceneNode> nodes = scene.nodes().stream().map(colors::recolor).toList();
        return new Scene(scene.picture().withDepth(0), scene.camera(), new World(1, Rgb.BLACK), colors.materials, nodes, List.of());
    }

    private SceneNode recolor(SceneNode node) {
        return switch (node) {
            case NodeGroup g -> g.withChildren(g.children().stream().map(this::recolor).toList());
            case Shape s -> s.withMaterial(nextMaterial());
        };
    }

    /** Returns the name of a new material; colors repeat after 15³ shapes. */
    private String nextMaterial() {
        int i = materials.size();
        Rgb color = new Rgb(channel(i), channel(i / LEVELS), channel(i / LEVELS / LEVELS));
        Material material = Material.of("flat" + i).withAmbient(color).withDiffuse(Rgb.BLACK).withShininess(1);
        materials.add(material);
        return material.name();
    }

    private static double channel(int i) {
        return ViewTransform.linear(STEP * (1 + i % LEVELS));
    }
}
