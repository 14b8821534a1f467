package lightning.format.jen;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lightning.base.text.Quote;
import lightning.base.work.Progress;
import lightning.format.MeshFormat;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.NamedMesh;
import lightning.scene.Mesh;

/**
 * Finds the meshes of one scene: beside its file or in {@code meshes/} ({@link AssetSearchPath}). Each file is read once, and what
 * several shapes show is one mesh.
 */
final class MeshFolder {
    static final String NAME = "meshes";

    private final AssetSearchPath searchPath;
    private final Map<Path, MeshParts> cache = new HashMap<>();
    private long triangles;

    /** @param scene the folder that holds the scene file */
    MeshFolder(Path scene) {
        searchPath = new AssetSearchPath(scene, "mesh file", NAME);
    }

    /**
     * A mesh.
     *
     * @param part the name of a part of the file; empty for all that it holds
     * @throws UnusableFileException if there is no such file inside the folders, if a link leads out of them, if it is none that can
     *                               be read, beyond {@link JenLimits} or has no such part
     */
    Mesh load(String file, String part) throws UnusableFileException {
        return searchPath.read(file, path -> load(file, part, path));
    }

    private Mesh load(String file, String part, Path path) throws UnusableFileException, IOException, MeshException {
        MeshParts parts = cache.get(path);
        if (parts == null) {
            parts = new MeshParts(read(file, path));
            cache.put(path, parts);
        }
        return part.isEmpty() ? parts.merged() : parts.part(part, file);
    }

    private List<NamedMesh> read(String file, Path path) throws UnusableFileException, IOException, MeshException {
        if (cache.size() == JenLimits.MESHES) {
            throw new UnusableFileException("a scene may have at most " + JenLimits.MESHES + " mesh files, found another, "
                    + Quote.of(file));
        }
        List<NamedMesh> parts = MeshFormat.meshes(path, Progress.NONE);
        triangles += parts.stream().mapToLong(p -> p.mesh().triangleCount()).sum();
        if (triangles > JenLimits.TRIANGLES) {
            throw new UnusableFileException("mesh file " + Quote.of(file) + " is one too many: all meshes together must have at most "
                    + JenLimits.TRIANGLES + " triangles");
        }
        return parts;
    }
}
