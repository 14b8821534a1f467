package lightning.layer;

/**
 * Estimate for writing a file, from some of its lines.
 *
 * @param fileBytes size of the file
 * @param memoryBytes memory for writing, in addition to the cache
 * @param seconds time for writing
 */
public record WriteEstimate(long fileBytes, long memoryBytes, double seconds) {}
