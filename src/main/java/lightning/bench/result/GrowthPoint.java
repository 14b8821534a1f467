package lightning.bench.result;

import java.util.List;

/**
 * Times at one point of a growth curve.
 *
 * @param at        number of pixels, lights, shapes or reflection bounces
 * @param fullTrace time of the traditional trace
 * @param edits     time of each kind of edit at setting exact, with stale reflections
 */
public record GrowthPoint(long at, TimeSamples fullTrace, List<EditTime> edits) {
    public GrowthPoint {
        edits = List.copyOf(edits);
    }

    /** Time of one kind of edit. */
    public record EditTime(String edit, TimeSamples time) {}
}
