package lightning.bench;

import java.util.List;

/**
 * Times at one point of a growth curve.
 *
 * @param at        how many pixels, lights, shapes or mirror bounces
 * @param fullTrace the traditional trace
 * @param edits     each kind of edit at grade exact, mirrors stale
 */
public record GrowthPoint(long at, TimeSamples fullTrace, List<EditTime> edits) {
    public GrowthPoint {
        edits = List.copyOf(edits);
    }

    /** The time of one kind of edit. */
    public record EditTime(String edit, TimeSamples time) {}
}
