package lightning.bench.result;

import java.util.List;
import java.util.Optional;

/**
 * Costs of indirect light on one scene, in the first pass and in edits, each compared with the scene without it.
 *
 * @param width         pixels
 * @param height        pixels
 * @param lights        number of lights
 * @param settings      settings of the indirect light
 * @param first         time of the first pass
 * @param without       time of the first pass without indirect light
 * @param fullTrace     times of the full traces that check the edits
 * @param bytesPerPixel additional bytes of the cache per pixel
 * @param gatherPoints  number of gather points
 * @param surfels       number of surfels
 * @param edits         edits in order of measurement
 */
public record IndirectCost(String scene, int width, int height, int lights, String settings, TimeSamples first, TimeSamples without,
        TimeSamples fullTrace, double bytesPerPixel, int gatherPoints, int surfels, List<Edit> edits) {
    public IndirectCost {
        edits = List.copyOf(edits);
    }

    /**
     * Update after one edit.
     *
     * @param edit    name of the case, as in {@code intensity}
     * @param value   change, as in {@code sun: intensity 1 → 0.6}
     * @param time    time of the update
     * @param without time of the update of the scene without indirect light
     * @param equal   whether the image is equal to a full trace in every bit
     */
    public record Edit(String edit, String value, TimeSamples time, TimeSamples without, boolean equal) {
        /** Returns the additional time in milliseconds; not negative. */
        public double extraMs() {
            return Math.max(0, time.median() - without.median());
        }
    }

    /** Returns the additional time of the first pass in milliseconds; not negative. */
    public double extraMs() {
        return Math.max(0, first.median() - without.median());
    }

    /** Returns an edit by its name. */
    public Optional<Edit> find(String edit) {
        return edits.stream().filter(e -> e.edit().equals(edit)).findFirst();
    }
}
