package lightning.format.jen.asset;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Set;
import lightning.format.hdr.HdrReader;
import lightning.format.mesh.MeshException;
import lightning.scene.asset.EnvironmentMap;
import org.jspecify.annotations.Nullable;

/** Loader for the environment map of a scene, with the same search path as textures ({@link AssetSearchPath}). Keeps the last one. */
public final class EnvironmentFolder {
    private final AssetSearchPath searchPath;
    /** Last map and its file; null before. A scene has one. */
    private @Nullable EnvironmentMap map;
    private @Nullable Path path;

    /**
     * Creates a loader.
     *
     * @param scene folder of the scene file
     */
    public EnvironmentFolder(Path scene) {
        searchPath = FileKind.ENVIRONMENT.searchPath(scene);
    }

    /** Returns the file that was read last. */
    Set<Path> files() {
        return path == null ? Set.of() : Set.of(path);
    }

    /**
     * Loads an environment map.
     *
     * @throws UnusableFileException if the file does not exist in the folders, a link leads out of them, or it is not a
     *     valid image
     */
    public EnvironmentMap load(String file) throws UnusableFileException {
        return searchPath.read(file, this::load);
    }

    private EnvironmentMap load(Path file) throws IOException, MeshException {
        if (map == null || !file.equals(path)) {
            map = HdrReader.read(file);
            path = file;
        }
        return map;
    }
}
