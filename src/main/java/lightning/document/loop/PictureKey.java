package lightning.document.loop;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.file.ContentDigest;
import lightning.base.file.ContentHash;
import lightning.format.jen.JenDocument;
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
 * Name under which the picture of a scene is kept: hashes of everything that determines it. Those are the program, the scene's text, and the
 * images, profiles and meshes as they were read. Their files may be newer, or copied with the scene.
 *
 * @param text    hash of the program and the text
 * @param content hash of images, profiles and meshes
 */
record PictureKey(ContentHash text, ContentHash content) {
    /** Scenes with more objects have long texts. */
    private static final int MAX_SHAPES = 20_000;

    /** Returns the hash of the program and a scene's text; empty if the scene is too large. */
    static Optional<ContentHash> textOf(Scene scene, String program) {
        if (scene.stage().shapes().size() > MAX_SHAPES) {
            return Optional.empty();
        }
        var digest = new ContentDigest();
        digest.add(program);
        digest.add(JenDocument.of(scene).text());
        return Optional.of(digest.hash());
    }

    /** Returns the hash of what was read from the files of a scene; takes a moment if that is much. */
    static ContentHash contentOf(Scene scene) {
        Map<ContentDigest.Content, ContentHash> known = new IdentityHashMap<>();
        var all = new ContentDigest();
        Stream.of(contents(scene.materials(), MaterialAttribute.ALL), contents(scene.lights(), LightAttribute.ALL),
                contents(List.of(scene.world()), World.ATTRIBUTES), contents(scene.world().named(), Dome.ATTRIBUTES), meshes(scene.nodes()))
                .flatMap(contents -> contents)
                .forEach(content -> all.add(known.computeIfAbsent(content, ContentDigest::hash).bytes()));
        return all.hash();
    }

    private static <T> Stream<ContentDigest.Content> contents(List<T> records, List<? extends SceneAttribute<T, ?>> attributes) {
        return records.stream().flatMap(record -> attributes.stream().flatMap(attribute -> attribute.content(record).stream()));
    }

    private static Stream<ContentDigest.Content> meshes(List<SceneNode> nodes) {
        return nodes.stream().flatMap(node -> switch (node) {
            case NodeGroup g -> meshes(g.children());
            case Shape s -> s.solid() instanceof Solid.TriangleMesh t ? Stream.of(t.mesh()) : Stream.empty();
        });
    }

    /** Returns the name of the picture's file. */
    String fileName() {
        return prefix(text) + content.hex().substring(0, 32) + KeptPictures.EXTENSION;
    }

    /** Returns what the names of the files of all pictures with a text start with. */
    static String prefix(ContentHash text) {
        return text.hex().substring(0, 32) + '-';
    }
}
