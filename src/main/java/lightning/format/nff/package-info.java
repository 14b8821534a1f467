/**
 * Neutral File Format (Haines, A proposal for standard graphics environments, 1987; version 3.1, 1992): a view, a
 * background, lights, and shapes with the last preceding fill.
 *
 * <pre>{@code
 * try (ByteSource source = ByteSource.open(Path.of("balls.nff"), Progress.NONE)) {
 *     NffFile file = NffReader.read(source, new ConversionNotes());
 * }
 * }</pre>
 */
@NullMarked
package lightning.format.nff;

import org.jspecify.annotations.NullMarked;
