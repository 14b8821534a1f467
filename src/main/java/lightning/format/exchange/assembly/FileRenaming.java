package lightning.format.exchange.assembly;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Environment;
import lightning.scene.asset.Gobo;
import lightning.scene.asset.IesProfile;
import lightning.scene.asset.LightTexture;
import lightning.scene.asset.TextureMap;
import lightning.scene.light.Light;
import lightning.scene.material.Material;
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
        return scene.withNodes(nodes(scene.nodes())).withMaterials(scene.materials().stream().map(this::material).toList())
                .withLights(scene.lights().stream().map(this::light).toList()).withWorld(world(scene.world()));
    }

    private List<SceneNode> nodes(List<SceneNode> nodes) {
        return nodes.stream().<SceneNode>map(node -> switch (node) {
            case NodeGroup group -> group.withChildren(nodes(group.children()));
            case Shape shape -> shape.solid() instanceof Solid.TriangleMesh t
                    ? shape.withSolid(new Solid.TriangleMesh(newName.apply(t.file()), t.part(), t.showsColors(), t.mesh()))
                    : shape;
        }).toList();
    }

    private Material material(Material m) {
        return m.withTexture(map(m.texture())).withGlowMap(map(m.glowMap())).withCutout(m.cutout().withMap(map(m.cutout().map())))
                .withBumpMapping(m.bumpMapping().withBump(map(m.bumpMapping().bump())).withNormalMap(map(m.bumpMapping().normalMap())));
    }

    private Optional<TextureMap> map(Optional<TextureMap> map) {
        return map.map(m -> new TextureMap(newName.apply(m.file()), m.repeatU(), m.repeatV(), m.image(), m.isClamped()));
    }

    private Light light(Light light) {
        return light.withGobo(light.gobo().map(g -> new Gobo(newName.apply(g.file()), g.image())))
                .withProfile(light.profile().map(p -> new IesProfile(newName.apply(p.file()), p.photometry())))
                .withTexture(light.texture().map(t -> new LightTexture(newName.apply(t.file()), t.image())));
    }

    private World world(World world) {
        return world.withEnvironment(world.environment().map(e -> new Environment(newName.apply(e.file()), e.map())));
    }
}
