package lightning.format.gltf;

import lightning.scene.node.Mesh;

/**
 * One primitive of a glTF mesh.
 *
 * @param mesh index of its mesh in the file
 * @param name unique in the file, printable on one line
 * @param primitive index in its mesh
 * @param material index of its material; −1 for none
 * @param vertices index in the file of each of its vertices, if it can be posed by a skin or morph targets; otherwise empty
 */
public record GltfPart(int mesh, int primitive, String name, int material, Mesh triangles, int[] vertices) {}
