package lightning.bench;

import java.util.List;
import java.util.Optional;
import lightning.bench.accuracy.AccuracySetting;

/**
 * One edit with one value.
 *
 * @param value what was changed to what, as in {@code sun: color 1 1 1 → 1 0 0}
 * @param rungs one for each grade of accuracy that the scene has, from the roughest to the full trace
 */
public record ValueResult(String value, List<SweepPointResult> rungs) {
    public ValueResult {
        rungs = List.copyOf(rungs);
    }

    /** That of a grade that the scene has. */
    public SweepPointResult point(AccuracySetting setting) {
        return find(setting).orElseThrow();
    }

    /** That of a grade; empty where the scene does not have it. */
    public Optional<SweepPointResult> find(AccuracySetting setting) {
        return rungs.stream().filter(point -> point.grade() == setting).findFirst();
    }
}
