package lightning.format.jen;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.text.Quote;
import lightning.scene.Gobo;
import lightning.scene.Group;
import lightning.scene.Material;
import lightning.scene.Mesh;
import lightning.scene.Node;
import lightning.scene.Panorama;
import lightning.scene.Photometry;
import lightning.scene.Profile;
import lightning.scene.Relief;
import lightning.scene.SampleMeaning;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.Sky;
import lightning.scene.Solid;
import lightning.scene.Texture;
import lightning.scene.TextureMap;

/**
 * The files that a scene already holds, and others of a folder.
 *
 * @param folder where other files are looked for, as if the scene file were in it; empty where none is read
 */
record HeldFiles(Scene scene, Optional<Path> folder) implements SceneFiles {
    @Override
    public Texture texture(String file, SampleMeaning samples) {
        Optional<Texture> held = scene.materials().stream().flatMap(m -> maps(m, samples)).filter(t -> t.file().equals(file))
                .map(TextureMap::image).findFirst();
        Optional<Texture> projected =
                scene.lights().stream().flatMap(l -> l.gobo().stream()).filter(g -> samples == SampleMeaning.COLOR && g.file().equals(file))
                        .map(Gobo::image).findFirst();
        return held.or(() -> projected).orElseGet(() -> read("texture", file, f -> new TextureFolder(f).load(file, samples)));
    }

    private static Stream<TextureMap> maps(Material material, SampleMeaning samples) {
        Relief relief = material.relief();
        return switch (samples) {
            case COLOR -> material.texture().stream();
            case NUMBER -> Stream.concat(relief.bump().stream(), relief.normals().stream());
            case OPACITY -> material.cutout().cutout().stream();
        };
    }

    @Override
    public Photometry profile(String file) {
        return scene.lights().stream().flatMap(l -> l.profile().stream()).filter(p -> p.file().equals(file)).map(Profile::photometry)
                .findFirst()
                .orElseGet(() -> read("profile", file, f -> new ProfileFolder(f).load(file)));
    }

    @Override
    public Sky sky(String file) {
        return scene.world().environment().filter(p -> p.file().equals(file)).map(Panorama::sky)
                .orElseGet(() -> read("environment", file, f -> new SkyFolder(f).load(file)));
    }

    @Override
    public Mesh mesh(String file, String part) {
        Mesh held = held(scene.nodes(), file, part);
        return held != null ? held : read("file", file, f -> new MeshFolder(f).load(file, part));
    }

    private static Mesh held(List<Node> nodes, String file, String part) {
        for (Node node : nodes) {
            Mesh held = switch (node) {
                case Group g -> held(g.children(), file, part);
                case Shape s -> s.solid() instanceof Solid.Triangles t && t.file().equals(file) && t.part().equals(part) ? t.mesh() : null;
            };
            if (held != null) {
                return held;
            }
        }
        return null;
    }

    private interface Reader<T> {
        T read(Path folder) throws UnusableFileException;
    }

    private <T> T read(String property, String file, Reader<T> reader) {
        Path from = folder.orElseThrow(() -> new IllegalArgumentException(
                property + " must be one that the scene already has, was " + Quote.of(file)));
        try {
            return reader.read(from);
        } catch (UnusableFileException e) {
            throw new IllegalArgumentException(e.getMessage(), e);
        }
    }
}
