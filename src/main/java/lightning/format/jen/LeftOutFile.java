package lightning.format.jen;

import lightning.format.jen.asset.MeshFolder;
import lightning.format.jen.asset.TextureFolder;

/**
 * File that a scene file names and the scene lacks, since it cannot be used.
 *
 * @param property property that names it
 * @param file its name in the scene file
 */
record LeftOutFile(String property, String file) {
    /** Returns the folder for such files next to the scene. */
    String subfolder() {
        return property.equals(BlockTypes.FILE) ? MeshFolder.NAME : TextureFolder.NAME;
    }
}
