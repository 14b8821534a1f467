package lightning.bench;

/**
 * A picture by programs that have just been started, in turns: whole processes, from the start to the end, with the picture as a
 * PNG file.
 *
 * @param process   ours: {@code lightning render}
 * @param processor processor time of it, all threads together; null where the system does not tell
 * @param rival     another program; null where none is installed
 */
public record ColdStart(TimeSamples process, TimeSamples processor, Rival rival) {

    /**
     * The same picture by another program.
     *
     * @param program   its name and version
     * @param process   as ours
     * @param processor as ours
     * @param share     the median of our process in units of that of its
     */
    public record Rival(String program, TimeSamples process, TimeSamples processor, double share) {}
}
