/**
 * Mesh files of all formats.
 *
 * <pre>{@code
 * List<NamedMesh> parts = MeshFormat.meshes(Path.of("statue.ply"), Progress.NONE);
 * Mesh mesh = parts.getFirst().mesh();
 * }</pre>
 */
@NullMarked
package lightning.format;

import org.jspecify.annotations.NullMarked;
