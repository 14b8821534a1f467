package lightning.bench.result;

import static java.util.Objects.requireNonNull;

import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import lightning.render.measure.AccuracySetting;
import lightning.scene.paper.PaperCase;

/**
 * Results of one kind of edit on a scene, for each of its values.
 *
 * @param edit        name of the case, as in {@code angle-larger}
 * @param figure      figure of the paper, as in {@code Fig. 10}; empty if none
 * @param paperSaving saving in the paper on its own scene, percent of a full trace's time; NaN if not printed
 * @param saving      saving of the default setting, percent of the full trace's time: mean of all values, as in the paper; NaN if any is
 *         uncertain
 * @param cap         maximum saving given ray counts and memory, percent, mean of all values
 * @param values      results per value, at least one
 */
public record EditResult(String edit, String figure, double paperSaving, double saving, double cap, List<ValueResult> values) {
    public EditResult {
        values = List.copyOf(values);
    }

    public static EditResult of(PaperCase edit, List<ValueResult> values) {
        return new EditResult(edit.name(), edit.figure(), edit.paperSaving(),
                average(values, AccuracySetting.DEFAULT, SweepPointResult::saving),
                average(values, AccuracySetting.DEFAULT, point -> requireNonNull(point.work()).cap()), values);
    }

    /** Returns the saving of a setting, mean of all values; NaN if not measured or any is uncertain. */
    public double saving(AccuracySetting setting) {
        return average(values, setting, SweepPointResult::saving);
    }

    private static double average(List<ValueResult> values, AccuracySetting setting, ToDoubleFunction<SweepPointResult> measure) {
        return values.stream().flatMap(value -> value.find(setting).stream()).mapToDouble(measure).average().orElse(Double.NaN);
    }

    /** Returns a setting's result for the first value; empty if not measured. */
    public Optional<SweepPointResult> first(AccuracySetting setting) {
        return values.stream().findFirst().flatMap(value -> value.find(setting));
    }
}
