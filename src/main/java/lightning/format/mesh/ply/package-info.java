/**
 * Files in Stanford's polygon format, PLY: text, and binary in either order of bytes (Turk, The PLY polygon file format, 1994).
 *
 * <pre>{@code
 * try (ByteSource source = ByteSource.open(Path.of("bunny.ply"), Progress.NONE)) {
 *     Mesh mesh = PlyReader.read(source, new ConversionNotes());
 * }
 * }</pre>
 */
package lightning.format.mesh.ply;
