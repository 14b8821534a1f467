package lightning.bench;

import java.util.List;

/**
 * The same picture traced by another program.
 *
 * @param program    its name and version
 * @param time       its own trace time
 * @param fullTrace  ours, measured in turns with it
 * @param ratio      how many times as fast ours is
 * @param agreement  share of pixels, 0…1, for which the pictures agree by {@code measure}
 * @param measure    what was compared
 * @param losses     what it cannot say, or not exactly
 */
public record PeerResult(String program, TimeSamples time, TimeSamples fullTrace, double ratio, double agreement, String measure,
        List<String> losses) {
    public PeerResult {
        losses = List.copyOf(losses);
    }
}
