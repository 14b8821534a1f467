package lightning.format.jen;

import java.nio.file.Path;

/** The files of a folder that scenes name; what was read once is kept. */
record AssetFolders(TextureFolder textures, ProfileFolder profiles, EnvironmentFolder environments, MeshFolder meshes) {
    /** @param folder where they are looked for, as if the scene were in it */
    static AssetFolders of(Path folder) {
        return new AssetFolders(new TextureFolder(folder), new ProfileFolder(folder), new EnvironmentFolder(folder),
                new MeshFolder(folder));
    }
}
