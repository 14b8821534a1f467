package lightning.format.jen.asset;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import lightning.base.file.UnusableFileException;
import lightning.base.text.Quote;
import lightning.format.ies.IesReader;
import lightning.format.mesh.MeshException;
import lightning.scene.value.Photometry;

/**
 * Loader for the light profiles of a scene, with the same search path as textures ({@link AssetSearchPath}). Each file is
 * read once.
 */
public final class ProfileFolder {
    private final AssetSearchPath searchPath;
    private final Map<Path, Photometry> cache = new HashMap<>();

    /**
     * Creates a loader.
     *
     * @param scene folder of the scene file
     */
    public ProfileFolder(Path scene) {
        searchPath = FileKind.PROFILE.searchPath(scene);
    }

    /** Returns the files that were read. */
    Set<Path> files() {
        return cache.keySet();
    }

    /**
     * Loads a profile.
     *
     * @throws UnusableFileException if the file does not exist in the folders, a link leads out of them, it is invalid, or
     *     there are more than {@link JenLimits#PROFILES}
     */
    public Photometry load(String file) throws UnusableFileException {
        return searchPath.read(file, path -> load(file, path));
    }

    private Photometry load(String file, Path path) throws IOException, MeshException {
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
