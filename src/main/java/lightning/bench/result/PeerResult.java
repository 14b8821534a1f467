package lightning.bench.result;

import java.util.List;

/**
 * Timing of another program that traces the same image.
 *
 * @param program   name and version
 * @param time      its own trace time
 * @param fullTrace our trace time, measured in turns with it
 * @param ratio     speedup of ours
 * @param agreement share of matching pixels, 0…1, by {@code measure}
 * @param measure   comparison method
 * @param losses    features that it does not support exactly
 */
public record PeerResult(String program, TimeSamples time, TimeSamples fullTrace, double ratio, double agreement, String measure,
        List<String> losses) {
    public PeerResult {
        losses = List.copyOf(losses);
    }
}
