/**
 * Mesh files of all formats.
 * A package of this group turns a file into values or values into a file; it traces nothing and knows no open document.
 *
 * <pre>{@code
 * List<NamedMesh> parts = MeshFormat.meshes(Path.of("statue.ply"), Progress.NONE);
 * Mesh mesh = parts.getFirst().mesh();
 * }</pre>
 */
@NullMarked
package lightning.format;

import org.jspecify.annotations.NullMarked;
