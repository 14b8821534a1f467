/**
 * Atomic file writes: an interrupted save loses nothing, and changes by other programs are never overwritten silently.
 *
 * <pre>{@code
 * AtomicFile.write(picture, out -> png.writeTo(out));
 * FileState now = AtomicFile.of(scene).ifUnchanged(asRead).write(bytes);
 * }</pre>
 */
@NullMarked
package lightning.base.file;

import org.jspecify.annotations.NullMarked;
