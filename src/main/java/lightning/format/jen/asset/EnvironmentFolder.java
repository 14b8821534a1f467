package lightning.format.jen.asset;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Set;
import java.util.function.Consumer;
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
     * @param notes receives a clause if it is reduced
     * @throws UnusableFileException if the file does not exist in the folders, a link leads out of them, or it is not a
     *     valid image
     */
    public EnvironmentMap load(String file, Consumer<String> notes) throws UnusableFileException {
        return searchPath.read(file, path -> load(path, notes));
    }

    private EnvironmentMap load(Path file, Consumer<String> notes) throws IOException, MeshException {
        if (map == null || !file.equals(path)) {
            map = EnvironmentReader.read(file, notes);
            path = file;
        }
        return map;
    }
}
