package lightning.format.jen;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import lightning.base.text.Quote;
import lightning.format.ies.IesReader;
import lightning.format.mesh.MeshException;
import lightning.scene.Photometry;

/** Finds the profiles of one scene where its textures are ({@link FileFolders}). Each file is read once. */
final class ProfileFolder {
    private final FileFolders folders;
    private final Map<Path, Photometry> read = new HashMap<>();

    /** @param scene the folder that holds the scene file */
    ProfileFolder(Path scene) {
        folders = FileKind.PROFILE.folders(scene);
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
}
