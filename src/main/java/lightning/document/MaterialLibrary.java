package lightning.document;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.scene.Scene;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;

/** Library of materials that come with the program, and edits that give them to objects. */
public final class MaterialLibrary {
    private static final List<Material> MATERIALS = read("materials.jen").materials();
    private static final Scene SAMPLE = read("sample.jen");
    private static final String SAMPLE_BALL = "sample ball";

    private MaterialLibrary() {}

    private static Scene read(String resource) {
        try (InputStream in = MaterialLibrary.class.getResourceAsStream(resource)) {
            return JenReader.read(new String(requireNonNull(in).readAllBytes(), StandardCharsets.UTF_8), resource, Path.of("")).scene();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (JenException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Returns all materials, similar ones together. Their names are English texts with a translation. */
    public static List<Material> materials() {
        return MATERIALS;
    }

    /** Returns the material of a name; empty if the library has none. */
    public static Optional<Material> find(String name) {
        return MATERIALS.stream().filter(m -> m.name().equals(name)).findFirst();
    }

    /** Returns a scene of a ball of a material, without surroundings to reflect. */
    public static Scene sample(Material material) {
        return assign(SAMPLE, SAMPLE_BALL, material);
    }

    /**
     * Gives a material to a shape, or to all shapes in a group. The scene gets the material, unless it has an equal one of this name; if it
     * has another of this name, the new one gets a number.
     */
    public static EditOutcome apply(Scene scene, String node, Material material) {
        return named(EditOutcome.of(() -> assign(scene, node, material)), material);
    }

    /** Gives a material to all shapes that have another one, as {@link #apply} does. */
    public static EditOutcome replace(Scene scene, String replaced, Material material) {
        return named(EditOutcome.of(() -> {
            Material added = unique(scene, material);
            return with(scene, added).withNodes(scene.nodes().stream().map(n -> replaced(n, replaced, added.name())).toList());
        }), material);
    }

    private static EditOutcome named(EditOutcome outcome, Material material) {
        return outcome.named(Messages.tr("Apply Material {0}", Quote.of(Messages.tr(material.name()))));
    }

    private static Scene assign(Scene scene, String node, Material material) {
        SceneNode before = scene.stage().node(node)
                .orElseThrow(() -> new RefusalException(Messages.tr("object {0} not found", Quote.of(node))));
        Material added = unique(scene, material);
        return with(scene, added).withNode(node, assigned(before, added.name()));
    }

    /** Returns the material with the name that it has in the scene. */
    static Material unique(Scene scene, Material material) {
        return Stream.iterate(1, i -> i + 1).map(i -> i == 1 ? material : material.withName(material.name() + " " + i))
                .filter(m -> scene.materials().stream().allMatch(other -> !other.name().equals(m.name()) || other.equals(m)))
                .findFirst().orElseThrow();
    }

    /** Returns the scene with a material, which it may have already. */
    static Scene with(Scene scene, Material material) {
        if (scene.materials().contains(material)) {
            return scene;
        }
        List<Material> all = new ArrayList<>(scene.materials());
        all.add(material);
        return scene.withMaterials(all);
    }

    private static SceneNode assigned(SceneNode node, String material) {
        return switch (node) {
            case NodeGroup g ->
                    new NodeGroup(g.name(), g.placement(), g.children().stream().map(n -> assigned(n, material)).toList(), g.visible());
            case Shape s -> s.withMaterial(material);
        };
    }

    private static SceneNode replaced(SceneNode node, String before, String after) {
        return switch (node) {
            case NodeGroup g -> {
                List<SceneNode> children = g.children().stream().map(n -> replaced(n, before, after)).toList();
                yield children.equals(g.children()) ? g : new NodeGroup(g.name(), g.placement(), children, g.visible());
            }
            case Shape s -> s.material().equals(before) ? s.withMaterial(after) : s;
        };
    }
}
