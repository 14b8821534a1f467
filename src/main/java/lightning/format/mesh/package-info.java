/**
 * Triangle meshes: immutable, and validated on construction.
 *
 * <pre>{@code
 * Mesh mesh = new Mesh(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2}, null, null, null);
 * float x = mesh.positions()[3 * mesh.triangles()[0]];
 * }</pre>
 */
@NullMarked
package lightning.format.mesh;

import lightning.scene.node.Mesh;
import org.jspecify.annotations.NullMarked;
