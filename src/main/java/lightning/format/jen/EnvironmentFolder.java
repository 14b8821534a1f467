package lightning.format.jen;

import java.nio.file.Path;
import lightning.format.hdr.HdrReader;
import lightning.scene.EnvironmentMap;

/** Finds the environment of one scene where its textures are ({@link AssetSearchPath}). */
final class EnvironmentFolder {
    private final AssetSearchPath searchPath;

    /** @param scene the folder that holds the scene file */
    EnvironmentFolder(Path scene) {
        searchPath = FileKind.ENVIRONMENT.searchPath(scene);
    }

    /**
     * The sky of a file.
     *
     * @throws UnusableFileException if there is no such file inside the folders, if a link leads out of them, or if it is no picture that
     *                               can be read
     */
    EnvironmentMap load(String file) throws UnusableFileException {
        return searchPath.read(file, HdrReader::read);
    }
}
