package lightning.bench;

import java.util.List;

/**
 * One edit with one value.
 *
 * @param value what was changed to what, as in {@code sun: color 1 1 1 → 1 0 0}
 * @param rungs one for each grade of accuracy, from the roughest to the full trace
 */
public record ValueResult(String value, List<RungResult> rungs) {
    public ValueResult {
        rungs = List.copyOf(rungs);
    }
}
