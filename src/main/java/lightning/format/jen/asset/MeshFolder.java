package lightning.format.jen.asset;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import lightning.base.file.UnusableFileException;
import lightning.base.text.Quote;
import lightning.base.work.Progress;
import lightning.format.MeshFormat;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.NamedMesh;
import lightning.scene.Stage;
import lightning.scene.node.Mesh;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;

/**
 * Loader for the meshes of a scene: next to its file or in {@code meshes/} ({@link AssetSearchPath}). Each file is read
 * once, and shapes with the same part share one mesh.
 */
public final class MeshFolder {
    public static final String NAME = "meshes";

    private final AssetSearchPath searchPath;
    private final Map<Path, MeshParts> cache = new HashMap<>();
    /** Meshes of files that are not read, by file and part. */
    private Map<List<String>, Mesh> provided = Map.of();
    private long triangles;

    /**
     * Creates a loader.
     *
     * @param scene folder of the scene file
     */
    public MeshFolder(Path scene) {
        searchPath = new AssetSearchPath(scene, "mesh file", NAME);
    }

    /**
     * Uses the meshes of a stage in place of their files from now on. A mesh that equals the earlier one of its file and part keeps the earlier
     * object, so that comparisons of scenes stay fast.
     */
    public void provide(Stage stage) {
        Map<List<String>, Mesh> meshes = new HashMap<>();
        for (Shape shape : stage.shapes()) {
            if (shape.solid() instanceof Solid.TriangleMesh solid && !solid.part().isEmpty()) {
                List<String> key = List.of(solid.file(), solid.part());
                Mesh earlier = provided.get(key);
                meshes.computeIfAbsent(key, _ -> solid.mesh().equals(earlier) ? earlier : solid.mesh());
            }
        }
        provided = meshes;
    }

    /** Provides the same meshes as another loader. */
    public void provideAs(MeshFolder other) {
        provided = other.provided;
    }

    /** Returns the files that were read. */
    Set<Path> files() {
        return cache.keySet();
    }

    /**
     * Loads a mesh.
     *
     * @param part name of a part of the file; empty for all parts
     * @throws UnusableFileException if the file does not exist in the folders, a link leads out of them, it is invalid,
     *     exceeds {@link JenLimits} or has no such part
     */
    public Mesh load(String file, String part) throws UnusableFileException {
        Mesh known = provided.get(List.of(file, part));
        return known != null ? known : searchPath.read(file, path -> load(file, part, path));
    }

    private Mesh load(String file, String part, Path path) throws IOException, MeshException {
        MeshParts parts = cache.get(path);
        if (parts == null) {
            parts = new MeshParts(read(file, path));
            cache.put(path, parts);
        }
        return part.isEmpty() ? parts.merged() : parts.part(part, file);
    }

    private List<NamedMesh> read(String file, Path path) throws IOException, MeshException {
        if (cache.size() == JenLimits.MESHES) {
            throw new UnusableFileException("a scene may have at most " + JenLimits.MESHES + " mesh files, found another, "
                    + Quote.of(file));
        }
        List<NamedMesh> parts = MeshFormat.meshes(path, Progress.NONE);
        triangles += parts.stream().mapToLong(p -> p.mesh().triangleCount()).sum();
        if (triangles > JenLimits.TRIANGLES) {
            throw new UnusableFileException("mesh file " + Quote.of(file) + " exceeds the limit: all meshes together must have at most "
                    + JenLimits.TRIANGLES + " triangles");
        }
        return parts;
    }
}
