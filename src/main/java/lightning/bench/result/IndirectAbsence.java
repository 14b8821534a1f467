package lightning.bench.result;

/**
 * Cost of indirect light that a scene does not have, compared with the same scene whose indirect light is hidden.
 *
 * @param width  pixels
 * @param height pixels
 * @param bytes  bytes of indirect light in the cache
 * @param rays   rays of the first pass more than those of a scene whose indirect light is hidden
 * @param equal  whether both images are equal in every bit
 * @param absent time of the first pass without indirect light
 * @param hidden time of the first pass with hidden indirect light, measured in turns with it
 */
public record IndirectAbsence(String scene, int width, int height, long bytes, long rays, boolean equal, TimeSamples absent,
        TimeSamples hidden) {}
