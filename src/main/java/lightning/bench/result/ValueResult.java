package lightning.bench.result;

import java.util.List;
import java.util.Optional;
import lightning.render.measure.AccuracySetting;

/**
 * Result of one edit with one value.
 *
 * @param value change, as in {@code sun: color 1 1 1 → 1 0 0}
 * @param rungs result per accuracy setting of the scene, from the roughest to the full trace
 */
public record ValueResult(String value, List<SweepPointResult> rungs) {
    public ValueResult {
        rungs = List.copyOf(rungs);
    }

    /** Returns the result of a setting that the scene has. */
    public SweepPointResult point(AccuracySetting setting) {
        return find(setting).orElseThrow();
    }

    /** Returns the result of a setting; empty if the scene does not have it. */
    public Optional<SweepPointResult> find(AccuracySetting setting) {
        return rungs.stream().filter(point -> point.grade() == setting).findFirst();
    }
}
