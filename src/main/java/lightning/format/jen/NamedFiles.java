package lightning.format.jen;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;
import lightning.base.text.Quote;
import lightning.scene.FromFile;
import lightning.scene.Group;
import lightning.scene.Material;
import lightning.scene.Node;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.Solid;

/** The files that a scene names, for who takes them elsewhere. */
public final class NamedFiles {
    private final SortedMap<String, Path> files = new TreeMap<>();
    private final Set<String> seen = new HashSet<>();
    private final FileFolders pictures;
    private final FileFolders meshes;

    private NamedFiles(Path folder) {
        pictures = new FileFolders(folder, "file", TextureFolder.NAME);
        meshes = new FileFolders(folder, "mesh file", MeshFolder.NAME);
    }

    /**
     * Where each lies, by its name in the scene.
     *
     * @param folder the folder that holds the scene file
     * @throws IOException if one is there no more, or one name means two files
     */
    public static SortedMap<String, Path> of(Scene scene, Path folder) throws IOException {
        var named = new NamedFiles(folder);
        for (String name : pictures(scene).distinct().toList()) {
            named.put(name, named.pictures);
        }
        named.putMeshes(scene.nodes());
        return named.files;
    }

    /** Whether a scene may write the name: a relative path of plain names that leads nowhere else. */
    public static boolean isAllowed(String name) {
        return FileName.isAllowed(name);
    }

    private static Stream<String> pictures(Scene scene) {
        Stream<String> materials = scene.materials().stream().flatMap(NamedFiles::pictures);
        Stream<FromFile> lights = scene.lights().stream().flatMap(l -> Stream.<FromFile>concat(l.gobo().stream(), l.profile().stream()));
        return Stream.concat(materials, Stream.concat(lights, scene.world().environment().stream()).map(FromFile::file));
    }

    private static Stream<String> pictures(Material material) {
        return Stream.of(material.texture(), material.relief().bump(), material.relief().normals()).flatMap(map -> map.stream())
                .map(map -> map.file());
    }

    private void putMeshes(List<Node> nodes) throws IOException {
        for (Node node : nodes) {
            switch (node) {
                case Group g -> putMeshes(g.children());
                case Shape s -> {
                    if (s.solid() instanceof Solid.Triangles t) {
                        put(t.file(), meshes);
                    }
                }
            }
        }
    }

    private void put(String name, FileFolders folders) throws IOException {
        // Many shapes show one mesh.
        if (folders == meshes && !seen.add(name)) {
            return;
        }
        try {
            Path path = folders.find(name);
            Path other = files.putIfAbsent(name, path);
            if (other != null && !other.equals(path)) {
                throw new IOException(Quote.of(name) + " is the name of two files of the scene, " + Quote.path(other) + " and "
                        + Quote.path(path) + "; elsewhere each needs a name of its own");
            }
        } catch (UnusableFileException e) {
            throw new IOException(e.getMessage(), e);
        }
    }
}
