/**
 * Atomic file writes: an interrupted save loses nothing, and changes by other programs are never overwritten silently.
 * Contents and formats of files belong to {@code format}.
 *
 * <pre>{@code
 * AtomicFile.write(picture, out -> png.writeTo(out));
 * FileState now = AtomicFile.of(scene).ifUnchanged(asRead).write(bytes);
 * }</pre>
 */
@NullMarked
package lightning.base.file;

import org.jspecify.annotations.NullMarked;
