package lightning.format.exchange.assembly;

import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;
import lightning.scene.Dome;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.light.LightAttribute;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;

/**
 * Scene that references its files by other names.
 *
 * @param newName returns the new name of a file, or the old one
 */
record FileRenaming(UnaryOperator<String> newName) {
    /** Moves some files of a scene into a subfolder. */
    static FileRenaming into(String folder, Set<String> files) {
        return new FileRenaming(name -> files.contains(name) ? folder + "/" + name : name);
    }

    /** Returns a scene that references its files by the new names. */
    Scene applyTo(Scene scene) {
        return scene.withNodes(nodes(scene.nodes()))
                .withMaterials(scene.materials().stream().map(m -> rename(m, MaterialAttribute.ALL)).toList())
                .withLights(scene.lights().stream().map(l -> rename(l, LightAttribute.ALL)).toList())
                .withWorld(rename(scene.world(), World.ATTRIBUTES)
                        .withNamed(scene.world().named().stream().map(d -> rename(d, Dome.ATTRIBUTES)).toList()));
    }

    private List<SceneNode> nodes(List<SceneNode> nodes) {
        return nodes.stream().<SceneNode>map(node -> switch (node) {
            case NodeGroup group -> group.withChildren(nodes(group.children()));
            case Shape shape -> shape.solid() instanceof Solid.TriangleMesh t
                    ? shape.withSolid(new Solid.TriangleMesh(newName.apply(t.file()), t.part(), t.showsColors(), t.mesh()))
                    : shape;
        }).toList();
    }

    private <T> T rename(T record, List<? extends SceneAttribute<T, ?>> attributes) {
        T renamed = record;
        for (SceneAttribute<T, ?> attribute : attributes) {
            renamed = attribute.renameFile(renamed, newName);
        }
        return renamed;
    }
}
