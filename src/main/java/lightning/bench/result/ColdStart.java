package lightning.bench.result;

import org.jspecify.annotations.Nullable;

/**
 * Cold-start timing of whole processes that render an image to a PNG file, measured in turns.
 *
 * @param process   time of {@code lightning render}
 * @param processor its processor time, all threads; null if the system does not report it
 * @param rival     another program; null if none is installed
 */
public record ColdStart(TimeSamples process, @Nullable TimeSamples processor, @Nullable Rival rival) {

    /**
     * Cold start of another program for the same image.
     *
     * @param program   name and version
     * @param process   time of its process
     * @param processor processor time of its process
     * @param share     median of our process relative to its median
     */
    public record Rival(String program, TimeSamples process, @Nullable TimeSamples processor, double share) {}
}
