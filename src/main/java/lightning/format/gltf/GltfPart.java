package lightning.format.gltf;

import lightning.scene.node.Mesh;

/**
 * One primitive of a glTF mesh.
 *
 * @param mesh index of its mesh in the file
 * @param name unique in the file, printable on one line
 * @param material index of its material; −1 for none
 */
public record GltfPart(int mesh, String name, int material, Mesh triangles) {}
