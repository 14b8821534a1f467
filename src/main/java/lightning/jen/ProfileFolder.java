package lightning.jen;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import lightning.ies.IesReader;
import lightning.mesh.MeshException;
import lightning.scene.Photometry;
import lightning.text.Quote;

/** Finds the profiles of one scene where its textures are ({@link FileFolders}). Each file is read once. */
final class ProfileFolder {
    private static final Pattern PROFILE = Pattern.compile(".+\\.ies", Pattern.CASE_INSENSITIVE);

    private final FileFolders folders;
    private final Map<Path, Photometry> read = new HashMap<>();

    /** @param scene the folder that holds the scene file */
    ProfileFolder(Path scene) {
        folders = new FileFolders(scene, "profile", TextureFolder.NAME);
    }

    /**
     * The intensities of a file.
     *
     * @throws UnusableFileException if there is no such file inside the folders, if a link leads out of them, if it is none of intensities, or
     *                               one more than {@link JenLimits#PROFILES}
     */
    Photometry load(String file) throws UnusableFileException {
        return folders.read(file, path -> load(file, path));
    }

    private Photometry load(String file, Path path) throws UnusableFileException, IOException, MeshException {
        Photometry known = read.get(path);
        if (known == null) {
            if (read.size() == JenLimits.PROFILES) {
                throw new UnusableFileException("a scene may have at most " + JenLimits.PROFILES + " profiles, found another, "
                        + Quote.of(file));
            }
            known = IesReader.read(path);
            read.put(path, known);
        }
        return known;
    }

    /** The files that a scene there can name, by the end of their names, in alphabetical order; none of unreadable folders. */
    List<String> names() {
        return folders.names(PROFILE);
    }
}
