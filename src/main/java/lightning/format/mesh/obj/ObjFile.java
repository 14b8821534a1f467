package lightning.format.mesh.obj;

import java.util.List;
import lightning.scene.Mesh;

/**
 * What an OBJ file holds.
 *
 * @param parts     at least one: an object, or a group, for each material that it has
 * @param libraries the files of materials that it names, as written
 */
public record ObjFile(List<ObjPart> parts, List<String> libraries) {

    /**
     * @param name     unique in the file, shown in one line
     * @param material as the file names it; empty where it names none
     */
    public record ObjPart(String name, String material, Mesh mesh) {}
}
