package lightning.format.mesh;

import lightning.scene.node.Mesh;

/**
 * Mesh with its name in a file.
 *
 * @param name not empty, printable on one line; unique in its file
 */
public record NamedMesh(String name, Mesh mesh) {}
