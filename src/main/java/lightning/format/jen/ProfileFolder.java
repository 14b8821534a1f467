package lightning.format.jen;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import lightning.base.text.Quote;
import lightning.format.ies.IesReader;
import lightning.format.mesh.MeshException;
import lightning.scene.Photometry;

/** Finds the profiles of one scene where its textures are ({@link AssetSearchPath}). Each file is read once. */
final class ProfileFolder {
    private final AssetSearchPath searchPath;
    private final Map<Path, Photometry> cache = new HashMap<>();

    /** @param scene the folder that holds the scene file */
    ProfileFolder(Path scene) {
        searchPath = FileKind.PROFILE.searchPath(scene);
    }

    /**
     * The intensities of a file.
     *
     * @throws UnusableFileException if there is no such file inside the folders, if a link leads out of them, if it is none of intensities, or
     *                               one more than {@link JenLimits#PROFILES}
     */
    Photometry load(String file) throws UnusableFileException {
        return searchPath.read(file, path -> load(file, path));
    }

    private Photometry load(String file, Path path) throws UnusableFileException, IOException, MeshException {
        Photometry cached = cache.get(path);
        if (cached == null) {
            if (cache.size() == JenLimits.PROFILES) {
                throw new UnusableFileException("a scene may have at most " + JenLimits.PROFILES + " profiles, found another, "
                        + Quote.of(file));
            }
            cached = IesReader.read(path);
            cache.put(path, cached);
        }
        return cached;
    }
}
