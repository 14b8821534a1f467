package lightning.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.image.ViewTransform;
import lightning.math.Rgb;
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
            case Group g -> new Group(g.name(), g.placement(), g.children().stream().map(this::colored).toList());
            case Shape.Sphere s -> new Shape.Sphere(s.name(), next(), s.placement());
            case Shape.Cone s -> new Shape.Cone(s.name(), next(), s.placement());
            case Shape.Cylinder s -> new Shape.Cylinder(s.name(), next(), s.placement());
            case Shape.Plane s -> new Shape.Plane(s.name(), next(), s.placement());
        };
    }

    /** The name of a new material; colours begin again after 15³ shapes. */
    private String next() {
        int i = materials.size();
        Rgb color = new Rgb(channel(i), channel(i / LEVELS), channel(i / LEVELS / LEVELS));
        Material material = new Material("flat" + i, color, Rgb.BLACK, Rgb.BLACK, 1, Rgb.BLACK, Optional.empty());
        materials.add(material);
        return material.name();
    }

    private static double channel(int i) {
        return ViewTransform.linear(STEP * (1 + i % LEVELS));
    }
}
