package lightning.format.jen;

import java.nio.file.Path;

/** The files of a folder that scenes name; what was read once is kept. */
record LoadedFiles(TextureFolder textures, ProfileFolder profiles, SkyFolder skies, MeshFolder meshes) {
    /** @param folder where they are looked for, as if the scene were in it */
    static LoadedFiles of(Path folder) {
        return new LoadedFiles(new TextureFolder(folder), new ProfileFolder(folder), new SkyFolder(folder), new MeshFolder(folder));
    }
}
