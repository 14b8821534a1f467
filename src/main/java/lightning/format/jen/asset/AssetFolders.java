package lightning.format.jen.asset;

import java.nio.file.Path;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Asset loaders of a folder; each caches the files it has read. */
public record AssetFolders(TextureFolder textures, ProfileFolder profiles, EnvironmentFolder environments, MeshFolder meshes) {
    /**
     * Returns the loaders of a folder.
     *
     * @param folder folder of the scene file, which files are resolved against
     */
    public static AssetFolders of(Path folder) {
        return new AssetFolders(new TextureFolder(folder), new ProfileFolder(folder), new EnvironmentFolder(folder),
                new MeshFolder(folder));
    }

    /** Returns all files that were read. */
    public Set<Path> files() {
        return Stream.of(textures.files(), profiles.files(), environments.files(), meshes.files()).flatMap(Set::stream)
                .collect(Collectors.toSet());
    }
}
