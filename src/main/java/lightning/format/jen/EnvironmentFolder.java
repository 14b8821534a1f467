package lightning.format.jen;

import java.nio.file.Path;
import lightning.format.hdr.HdrReader;
import lightning.scene.EnvironmentMap;

/** Loader for the environment map of a scene, with the same search path as textures ({@link AssetSearchPath}). */
final class EnvironmentFolder {
    private final AssetSearchPath searchPath;

    /**
     * Creates a loader.
     *
     * @param scene folder of the scene file
     */
    EnvironmentFolder(Path scene) {
        searchPath = FileKind.ENVIRONMENT.searchPath(scene);
    }

    /**
     * Loads an environment map.
     *
     * @throws UnusableFileException if the file does not exist in the folders, a link leads out of them, or it is not a
     *     valid image
     */
    EnvironmentMap load(String file) throws UnusableFileException {
        return searchPath.read(file, HdrReader::read);
    }
}
