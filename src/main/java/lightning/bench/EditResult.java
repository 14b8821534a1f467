package lightning.bench;

import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import lightning.bench.accuracy.AccuracySetting;
import lightning.bench.accuracy.PaperCase;

/**
 * One kind of edit on a scene, with each of its varying values.
 *
 * @param edit        the case's name, as in {@code angle-larger}
 * @param figure      where the paper shows it, as in {@code Fig. 10}; empty where it does not
 * @param paperSaving percent of a full trace's time that the paper saved on its own scene; NaN where it printed none
 * @param saving      percent of the full trace's time that the default grade saves: the average of all values, as the paper's are; NaN where
 *                    that of any value is not certain
 * @param cap         percent that ray counts and memory allow it to save, the average of all values
 * @param values      at least one
 */
public record EditResult(String edit, String figure, double paperSaving, double saving, double cap, List<ValueResult> values) {
    public EditResult {
        values = List.copyOf(values);
    }

    static EditResult of(PaperCase edit, List<ValueResult> values) {
        return new EditResult(edit.name(), edit.figure(), edit.paperSaving(),
                average(values, AccuracySetting.DEFAULT, SweepPointResult::saving),
                average(values, AccuracySetting.DEFAULT, point -> point.work().cap()), values);
    }

    /** What a grade saves, the average of all values; NaN where it was not measured or any value's is not certain. */
    public double saving(AccuracySetting setting) {
        return average(values, setting, SweepPointResult::saving);
    }

    private static double average(List<ValueResult> values, AccuracySetting setting, ToDoubleFunction<SweepPointResult> measure) {
        return values.stream().flatMap(value -> value.find(setting).stream()).mapToDouble(measure).average().orElse(Double.NaN);
    }

    /** A grade of the first value; empty where it was not measured. */
    public Optional<SweepPointResult> first(AccuracySetting setting) {
        return values.stream().findFirst().flatMap(value -> value.find(setting));
    }
}
