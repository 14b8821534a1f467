package lightning.format.mesh;

import lightning.scene.Mesh;

/**
 * A mesh as its file names it: a file may hold several.
 *
 * @param name not empty, shown in one line; unique in its file
 */
public record NamedMesh(String name, Mesh mesh) {}
