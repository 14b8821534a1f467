package lightning.bench.result;

import lightning.bench.accuracy.UpdateSaving;
import lightning.scene.paper.PaperCase;

/**
 * Update of a modern scene after one edit, at the default setting.
 *
 * @param edit      name of the case, as in {@code intensity}
 * @param value     change, as in {@code sun: intensity 1 → 0.6}
 * @param time      time of the update
 * @param fullTrace time of a full trace without a cache, measured in turns with it
 * @param saving    percent of the full trace's time; negative if slower; NaN if the quartiles of both overlap
 * @param equal     whether the image is equal to a full trace in every bit
 */
public record ModernEdit(String edit, String value, TimeSamples time, TimeSamples fullTrace, double saving, boolean equal) {

    public static ModernEdit of(PaperCase edit, UpdateSaving saving) {
        TimeSamples time = TimeSamples.of(saving.time());
        TimeSamples full = TimeSamples.of(saving.full());
        return new ModernEdit(edit.name(), edit.value(), time, full, time.isDistinctFrom(full) ? saving.percent() : Double.NaN,
                saving.isVerified());
    }
}
