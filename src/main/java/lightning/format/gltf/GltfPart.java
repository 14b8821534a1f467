package lightning.format.gltf;

import lightning.scene.Mesh;

/**
 * One primitive of a mesh of a glTF file.
 *
 * @param mesh     which of the file's meshes it is a part of
 * @param name     unique in the file, shown in one line
 * @param material which of the file's materials it has; −1 for none
 */
public record GltfPart(int mesh, String name, int material, Mesh triangles) {}
