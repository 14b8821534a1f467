/**
 * Writing files so that an interrupted save loses nothing, and nothing is overwritten that the user does not know of.
 *
 * <pre>{@code
 * AtomicFile.write(picture, out -> png.writeTo(out));
 * FileState now = AtomicFile.of(scene).ifStill(asRead).write(bytes);
 * }</pre>
 */
package lightning.base.file;
