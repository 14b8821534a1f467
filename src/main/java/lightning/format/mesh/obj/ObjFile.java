package lightning.format.mesh.obj;

import java.util.List;
import lightning.scene.node.Mesh;

/**
 * Content of an OBJ file.
 *
 * @param parts at least one; one part for each material of an object or group
 * @param libraries paths of the referenced material files, as written
 */
public record ObjFile(List<ObjPart> parts, List<String> libraries) {

    /**
     * Part of an OBJ file.
     *
     * @param name unique in the file, printable on one line
     * @param material name in the file; empty for none
     */
    public record ObjPart(String name, String material, Mesh mesh) {}
}
