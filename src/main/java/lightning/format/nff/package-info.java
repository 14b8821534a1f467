/**
 * Files of the Neutral File Format (Haines, A proposal for standard graphics environments, 1987; the format as of version 3.1, 1992):
 * a view, a background, lights, and shapes of which each has the fill that stands last before it.
 *
 * <pre>{@code
 * try (ByteSource source = ByteSource.open(Path.of("balls.nff"), Progress.NONE)) {
 *     NffFile file = NffReader.read(source, new ConversionNotes());
 * }
 * }</pre>
 */
package lightning.format.nff;
