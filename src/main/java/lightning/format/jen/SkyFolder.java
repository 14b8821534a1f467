package lightning.format.jen;

import java.nio.file.Path;
import lightning.format.hdr.HdrReader;
import lightning.scene.Sky;

/** Finds the environment of one scene where its textures are ({@link FileFolders}). */
final class SkyFolder {
    private final FileFolders folders;

    /** @param scene the folder that holds the scene file */
    SkyFolder(Path scene) {
        folders = FileKind.ENVIRONMENT.folders(scene);
    }

    /**
     * The sky of a file.
     *
     * @throws UnusableFileException if there is no such file inside the folders, if a link leads out of them, or if it is no picture that
     *                               can be read
     */
    Sky load(String file) throws UnusableFileException {
        return folders.read(file, HdrReader::read);
    }
}
