package lightning.bench.result;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.Objects;
import lightning.render.measure.AccuracySetting;
import lightning.render.measure.PictureError;
import org.jspecify.annotations.Nullable;

/**
 * Result of one accuracy setting for one edit.
 *
 * @param grade      accuracy setting; called level in result files
 * @param saving     percent of the full trace's time; negative if slower; NaN if the quartiles of both overlap
 * @param error      difference from the full trace
 * @param work       work of the update; null for the full trace
 * @param picture    image file, relative to the results; null if not written
 * @param difference file of the false-color difference from the full trace; null if not written or equal
 */
public record SweepPointResult(@JsonProperty("level") AccuracySetting grade, TimeSamples time, double saving, PictureError error,
        @Nullable UpdateWork work, @Nullable String picture, @Nullable String difference) {
    public SweepPointResult {
        // Checked here, as a missing field of a parsed file would otherwise surface only after all measurements.
        Objects.requireNonNull(grade, "missing level");
        Objects.requireNonNull(time, "missing time");
        Objects.requireNonNull(error, "missing error");
    }
}
