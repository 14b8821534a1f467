package lightning.format.jen;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import lightning.base.file.UnusableFileException;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.format.jen.asset.AssetSource;
import lightning.format.jen.asset.EnvironmentFolder;
import lightning.format.jen.asset.MeshFolder;
import lightning.format.jen.asset.ProfileFolder;
import lightning.format.jen.asset.TextureFolder;
import lightning.scene.Scene;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.asset.Gobo;
import lightning.scene.asset.IesProfile;
import lightning.scene.asset.LightTexture;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TextureUsage;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.node.Mesh;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Photometry;
import org.jspecify.annotations.Nullable;

/**
 * Assets already loaded by a scene, and others of a folder.
 *
 * @param folder   folder that further files are resolved against; empty to load none
 * @param replaced environment that the edit replaces
 */
record SceneAssets(Scene scene, Optional<Path> folder, Optional<Environment> replaced) implements AssetSource {
    SceneAssets(Scene scene, Optional<Path> folder) {
        this(scene, folder, Optional.empty());
    }

    /** Returns these assets for an edit that replaces an environment. */
    static AssetSource replacing(AssetSource files, Optional<Environment> environment) {
        return files instanceof SceneAssets assets ? new SceneAssets(assets.scene, assets.folder, environment) : files;
    }

    private Set<EnvironmentMap> otherEnvironments() {
        Set<EnvironmentMap> others = scene.world().images();
        replaced.ifPresent(environment -> others.remove(environment.map()));
        return others;
    }

    @Override
    public Texture texture(String file, TextureUsage samples) {
        Optional<Texture> existing = scene.materials().stream().flatMap(m -> maps(m, samples)).filter(t -> t.file().equals(file))
                .map(TextureMap::image).findFirst();
        Optional<Texture> projected =
                scene.lights().stream().flatMap(l -> l.gobo().stream()).filter(g -> samples == TextureUsage.COLOR && g.file().equals(file))
                        .map(Gobo::image).findFirst();
        Optional<Texture> shown = scene.lights().stream().flatMap(l -> l.texture().stream())
                .filter(t -> samples == TextureUsage.EMISSION && t.file().equals(file)).map(LightTexture::image).findFirst();
        return existing.or(() -> projected).or(() -> shown)
                .orElseGet(() -> read("texture", file, f -> new TextureFolder(f).load(file, samples, SceneAssets::refuse)));
    }

    /** Refuses a texture that a scene would show with fewer pixels: an edit has no place for a note. */
    private static void refuse(String note) {
        throw new RefusalException(note);
    }

    private static Stream<TextureMap> maps(Material material, TextureUsage samples) {
        return MaterialAttribute.MAPS.stream().filter(map -> map.usage().equals(Optional.of(samples)))
                .flatMap(map -> map.get(material).stream());
    }

    @Override
    public Photometry profile(String file) {
        return scene.lights().stream().flatMap(l -> l.profile().stream()).filter(p -> p.file().equals(file)).map(IesProfile::photometry)
                .findFirst()
                .orElseGet(() -> read("profile", file, f -> new ProfileFolder(f).load(file)));
    }

    @Override
    public EnvironmentMap environment(String file) {
        return Stream.concat(scene.world().environment().stream(), scene.world().named().stream().flatMap(d -> d.image().stream()))
                .filter(p -> p.file().equals(file)).map(Environment::map).findFirst()
                .orElseGet(() -> read("environment", file, f -> new EnvironmentFolder(f).load(file, otherEnvironments(), note -> {})));
    }

    @Override
    public Mesh mesh(String file, String part) {
        Mesh existing = findMesh(scene.nodes(), file, part);
        return existing != null ? existing : read("file", file, f -> new MeshFolder(f).load(file, part));
    }

    private static @Nullable Mesh findMesh(List<SceneNode> nodes, String file, String part) {
        for (SceneNode node : nodes) {
            Mesh existing = switch (node) {
                case NodeGroup g -> findMesh(g.children(), file, part);
                case Shape s ->
                        s.solid() instanceof Solid.TriangleMesh t && t.file().equals(file) && t.part().equals(part) ? t.mesh() : null;
            };
            if (existing != null) {
                return existing;
            }
        }
        return null;
    }

    private interface Reader<T> {
        T read(Path folder) throws UnusableFileException;
    }

    private <T> T read(String property, String file, Reader<T> reader) {
        Path assetFolder = folder.orElseThrow(() -> new RefusalException(
                property + " must be one that the scene already has, was " + Quote.of(file)));
        try {
            return reader.read(assetFolder);
        } catch (UnusableFileException e) {
            throw new RefusalException(String.valueOf(e.getMessage()), e);
        }
    }
}
