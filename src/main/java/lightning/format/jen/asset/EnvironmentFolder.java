package lightning.format.jen.asset;

import java.lang.ref.SoftReference;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import lightning.base.file.UnusableFileException;
import lightning.scene.asset.EnvironmentMap;
import org.jspecify.annotations.Nullable;

/** Loader for the environment maps of a scene, with the same search path as textures ({@link AssetSearchPath}). */
public final class EnvironmentFolder {
    private final AssetSearchPath searchPath;
    /** Maps that were read, as long as a scene has them or memory is not short. */
    private final Map<Path, SoftReference<EnvironmentMap>> maps = new HashMap<>();

    /**
     * Creates a loader.
     *
     * @param scene folder of the scene file
     */
    public EnvironmentFolder(Path scene) {
        searchPath = FileKind.ENVIRONMENT.searchPath(scene);
    }

    /** Returns the files that were read. */
    Set<Path> files() {
        return Set.copyOf(maps.keySet());
    }

    /**
     * Loads an environment map.
     *
     * @param others other maps of the scene, which count against the same limit of memory
     * @param notes receives a clause if it is reduced
     * @throws UnusableFileException if the file does not exist in the folders, a link leads out of them, it is not a
     *     valid image, or the maps would take too much memory
     */
    public EnvironmentMap load(String file, Set<EnvironmentMap> others, Consumer<String> notes) throws UnusableFileException {
        return searchPath.read(file, path -> load(file, path, others, notes));
    }

    private EnvironmentMap load(String name, Path file, Set<EnvironmentMap> others, Consumer<String> notes) throws UnusableFileException {
        SoftReference<EnvironmentMap> reference = maps.get(file);
        @Nullable
        EnvironmentMap known = reference == null ? null : reference.get();
        if (known != null && others.contains(known)) {
            return known;
        }
        long used = others.stream().mapToLong(EnvironmentMap::bytes).sum();
        if (known != null) {
            EnvironmentReader.checkMemory(name, known.width(), known.height(), known.bytes(), used);
            return known;
        }
        EnvironmentMap map = EnvironmentReader.read(name, file, used, notes);
        maps.put(file, new SoftReference<>(map));
        return map;
    }
}
