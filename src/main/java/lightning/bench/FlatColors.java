package lightning.bench;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.render.image.ViewTransform;
import lightning.scene.Group;
import lightning.scene.Material;
import lightning.scene.Node;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.World;

/**
 * Shows each shape of a scene in a flat colour of its own, without lights, mirrors or textures: two programs that agree on
 * the geometry show the same picture, but for pixels through whose centre an edge runs.
 */
final class FlatColors {
    /** Display codes between two colours of a channel: far more than programs round differently. */
    static final int STEP = 17;
    /** 15 codes in each of three channels, black left to the background. */
    private static final int LEVELS = 255 / STEP;

    private final List<Material> materials = new ArrayList<>();

    private FlatColors() {}

    static Scene of(Scene scene) {
        FlatColors colors = new FlatColors();
        List<Node> nodes = scene.nodes().stream().map(colors::colored).toList();
        return new Scene(scene.picture().withDepth(0), scene.camera(), new World(1, Rgb.BLACK), colors.materials, nodes, List.of());
    }

    private Node colored(Node node) {
        return switch (node) {
            case Group g -> g.withChildren(g.children().stream().map(this::colored).toList());
            case Shape s -> s.withMaterial(next());
        };
    }

    /** The name of a new material; colours begin again after 15³ shapes. */
    private String next() {
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
