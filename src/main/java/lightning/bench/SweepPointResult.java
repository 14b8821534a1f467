package lightning.bench;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.Objects;
import lightning.bench.accuracy.AccuracySetting;
import lightning.bench.accuracy.PictureError;

/**
 * One grade of accuracy for one edit.
 *
 * @param grade      in files of results it is called a level
 * @param saving     percent of the full trace's time; negative where it takes longer; NaN where the quartiles of both overlap, so that
 *                   nothing can be said
 * @param error      how far its picture is from the full trace
 * @param work       what it did; null for the full trace
 * @param picture    the file of its picture, relative to the results; null where none was written
 * @param difference the file of the false-color picture of its difference to the full trace; null where none was
 *                   written or there is none
 */
public record SweepPointResult(@JsonProperty("level") AccuracySetting grade, TimeSamples time, double saving, PictureError error,
        UpdateWork work, String picture,
        String difference) {
    public SweepPointResult {
        // Results that are read may lack anything, and would be missed only after all was measured.
        Objects.requireNonNull(grade, "missing level");
        Objects.requireNonNull(time, "missing time");
        Objects.requireNonNull(error, "missing error");
    }
}
