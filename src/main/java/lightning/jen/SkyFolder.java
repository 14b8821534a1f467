package lightning.jen;

import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import lightning.hdr.HdrReader;
import lightning.scene.Sky;

/** Finds the environment of one scene where its textures are ({@link FileFolders}). */
final class SkyFolder {
    private static final Pattern SKY = Pattern.compile(".+\\.hdr", Pattern.CASE_INSENSITIVE);

    private final FileFolders folders;

    /** @param scene the folder that holds the scene file */
    SkyFolder(Path scene) {
        folders = new FileFolders(scene, "environment", TextureFolder.NAME);
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

    /** The pictures that a scene there can name, by the end of their names, in alphabetical order; none of unreadable folders. */
    List<String> names() {
        return folders.names(SKY);
    }
}
