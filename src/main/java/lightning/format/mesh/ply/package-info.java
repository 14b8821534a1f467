/**
 * PLY files, the Stanford polygon format: text, and binary in both byte orders (Turk, The PLY polygon file format, 1994).
 *
 * <pre>{@code
 * try (ByteSource source = ByteSource.open(Path.of("bunny.ply"), Progress.NONE)) {
 *     Mesh mesh = PlyReader.read(source, new ConversionNotes());
 * }
 * }</pre>
 */
@NullMarked
package lightning.format.mesh.ply;

import org.jspecify.annotations.NullMarked;
