package lightning.format.jen;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import lightning.base.file.ParentFolder;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.format.MeshFormat;
import lightning.format.jen.asset.AssetSearchPath;
import lightning.format.jen.asset.FileName;
import lightning.format.jen.asset.MeshFolder;
import lightning.format.jen.asset.TextureFolder;
import lightning.format.mesh.MeshException;
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

/** Files that a scene references, with the buffers that its meshes name, for copying them elsewhere. */
public final class ReferencedFiles {
    private final SortedMap<String, Path> images = new TreeMap<>();
    private final SortedMap<String, Path> meshFiles = new TreeMap<>();
    private final AssetSearchPath textures;
    private final AssetSearchPath meshes;

    private ReferencedFiles(Path folder) {
        textures = new AssetSearchPath(folder, "file", TextureFolder.NAME);
        meshes = new AssetSearchPath(folder, "mesh file", MeshFolder.NAME);
    }

    /**
     * Returns the path of each file, by its name in the scene; a buffer has the name that is beside its mesh. Files that the scene was read
     * without are left out.
     *
     * @param folder folder of the scene file
     * @throws IOException if a file is missing, or one name refers to two files
     */
    public static SortedMap<String, Path> of(Scene scene, Path folder) throws IOException {
        SortedMap<String, Path> all = new TreeMap<>();
        bySubfolder(scene, folder).values().forEach(all::putAll);
        return all;
    }

    /** Returns the same by the subfolder that such files are in, unless they are next to the scene. */
    static SortedMap<String, SortedMap<String, Path>> bySubfolder(Scene scene, Path folder) throws IOException {
        var referenced = new ReferencedFiles(folder);
        for (String name : texturesAndProfiles(scene).distinct().toList()) {
            referenced.put(referenced.images, name, referenced.textures.find(name));
        }
        for (String name : meshes(scene.nodes()).filter(mesh -> !mesh.isMissing()).map(Solid.TriangleMesh::file).distinct().toList()) {
            Path file = referenced.meshes.find(name);
            referenced.put(referenced.meshFiles, name, file);
            for (Map.Entry<String, Path> further : furtherFiles(name, file).entrySet()) {
                referenced.put(referenced.meshFiles, further.getKey(), further.getValue());
            }
        }
        return new TreeMap<>(Map.of(TextureFolder.NAME, referenced.images, MeshFolder.NAME, referenced.meshFiles));
    }

    /** Returns the buffers of a mesh, by the names that are beside it. */
    static SortedMap<String, Path> furtherFiles(String name, Path mesh) throws IOException {
        try {
            SortedMap<String, Path> files = new TreeMap<>();
            for (Path further : MeshFormat.furtherFiles(mesh)) {
                files.put(nameBeside(name, mesh, further), further);
            }
            return files;
        } catch (MeshException e) {
            throw new IOException(e.getMessage(), e);
        }
    }

    /** Returns the name of a file in the folder of a mesh, or below it. */
    private static String nameBeside(String name, Path mesh, Path further) throws IOException {
        String folder = name.substring(0, name.lastIndexOf('/') + 1);
        String beside = folder + StreamSupport.stream(ParentFolder.of(mesh).relativize(further).spliterator(), false).map(Path::toString)
                .collect(Collectors.joining("/"));
        try {
            FileName.check("the file that " + Quote.of(name) + " names", beside, MeshFolder.NAME);
            return beside;
        } catch (RefusalException e) {
            throw new IOException(e.getMessage(), e);
        }
    }

    /** Returns the files that some scenes of a folder reference, as far as they exist, without the buffers of meshes. */
    static Set<Path> existing(Collection<Scene> scenes, Path folder) {
        var textures = new AssetSearchPath(folder, "file", TextureFolder.NAME);
        var meshes = new AssetSearchPath(folder, "mesh file", MeshFolder.NAME);
        Set<Path> existing = new HashSet<>();
        for (Scene scene : scenes) {
            texturesAndProfiles(scene).distinct().forEach(name -> findExisting(textures, name).ifPresent(existing::add));
            meshes(scene.nodes()).map(Solid.TriangleMesh::file).distinct()
                    .forEach(name -> findExisting(meshes, name).ifPresent(existing::add));
        }
        return existing;
    }

    private static Optional<Path> findExisting(AssetSearchPath folders, String name) {
        try {
            return Optional.of(folders.find(name));
        } catch (IOException | RefusalException e) {
            return Optional.empty();
        }
    }

    private static Stream<Solid.TriangleMesh> meshes(List<SceneNode> nodes) {
        return nodes.stream().flatMap(node -> switch (node) {
            case NodeGroup g -> meshes(g.children());
            case Shape s -> s.solid() instanceof Solid.TriangleMesh t ? Stream.of(t) : Stream.empty();
        });
    }

    /** Returns whether a scene may contain the name: a relative path of plain names that stays inside the folders. */
    public static boolean isAllowed(String name) {
        return FileName.isAllowed(name);
    }

    /** Returns the names of the images of materials and on the faces of lights, without gobos and environments; names may repeat. */
    public static Stream<String> textures(Scene scene) {
        return Stream.concat(files(scene.materials(), MaterialAttribute.ALL), files(scene.lights(), List.of(LightAttribute.TEXTURE)));
    }

    private static Stream<String> texturesAndProfiles(Scene scene) {
        return Stream.of(files(scene.materials(), MaterialAttribute.ALL), files(scene.lights(), LightAttribute.ALL),
                files(List.of(scene.world()), World.ATTRIBUTES), files(scene.world().named(), Dome.ATTRIBUTES)).flatMap(names -> names);
    }

    private static <T> Stream<String> files(List<T> records, List<? extends SceneAttribute<T, ?>> attributes) {
        return records.stream().flatMap(record -> attributes.stream().flatMap(attribute -> attribute.file(record).stream()));
    }

    private void put(SortedMap<String, Path> files, String name, Path path) throws IOException {
        Path other = images.getOrDefault(name, meshFiles.getOrDefault(name, path));
        if (!other.equals(path)) {
            throw new IOException(Quote.of(name) + " is the name of two files of the scene, " + Quote.path(other) + " and "
                    + Quote.path(path) + "; give each a different name");
        }
        files.put(name, path);
    }

}
