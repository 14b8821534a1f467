package lightning.format.exchange;

import java.util.List;
import java.util.Optional;
import lightning.scene.Environment;
import lightning.scene.Gobo;
import lightning.scene.IesProfile;
import lightning.scene.Light;
import lightning.scene.LightTexture;
import lightning.scene.Material;
import lightning.scene.NodeGroup;
import lightning.scene.Scene;
import lightning.scene.SceneNode;
import lightning.scene.Shape;
import lightning.scene.Solid;
import lightning.scene.TextureMap;
import lightning.scene.World;

/**
 * Scene whose files are in a subfolder.
 *
 * @param prefix start of each file name, such as {@code house/}
 */
record FilePrefix(String prefix) {
    /** Returns a scene that references its files with the prefix. */
    Scene applyTo(Scene scene) {
        return scene.withNodes(nodes(scene.nodes())).withMaterials(scene.materials().stream().map(this::material).toList())
                .withLights(scene.lights().stream().map(this::light).toList()).withWorld(world(scene.world()));
    }

    private List<SceneNode> nodes(List<SceneNode> nodes) {
        return nodes.stream().<SceneNode>map(node -> switch (node) {
            case NodeGroup group -> group.withChildren(nodes(group.children()));
            case Shape shape -> shape.solid() instanceof Solid.TriangleMesh t
                    ? shape.withSolid(new Solid.TriangleMesh(prefix + t.file(), t.part(), t.showsColors(), t.mesh()))
                    : shape;
        }).toList();
    }

    private Material material(Material m) {
        return m.withTexture(map(m.texture())).withGlowMap(map(m.glowMap())).withCutout(m.cutout().withMap(map(m.cutout().map())))
                .withBumpMapping(m.bumpMapping().withBump(map(m.bumpMapping().bump())).withNormalMap(map(m.bumpMapping().normalMap())));
    }

    private Optional<TextureMap> map(Optional<TextureMap> map) {
        return map.map(m -> new TextureMap(prefix + m.file(), m.repeatU(), m.repeatV(), m.image()));
    }

    private Light light(Light light) {
        return light.withGobo(light.gobo().map(g -> new Gobo(prefix + g.file(), g.image())))
                .withProfile(light.profile().map(p -> new IesProfile(prefix + p.file(), p.photometry())))
                .withTexture(light.texture().map(t -> new LightTexture(prefix + t.file(), t.image())));
    }

    private World world(World world) {
        return world.withEnvironment(world.environment().map(e -> new Environment(prefix + e.file(), e.map())));
    }
}
