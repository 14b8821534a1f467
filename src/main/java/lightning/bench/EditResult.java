package lightning.bench;

import java.util.List;

/**
 * One kind of edit on a scene, with each of its varying values.
 *
 * @param edit        the case's name, as in {@code angle-larger}
 * @param figure      where the paper shows it, as in {@code Fig. 10}; empty where it does not
 * @param paperSaving percent of a full trace's time that the paper saved on its own scene; NaN where it printed none
 * @param saving      percent of the full trace's time that grade exact saves: the average of all values, as the paper's are
 * @param cap         percent that ray counts and memory allow it to save, the average of all values
 * @param values      at least one
 */
public record EditResult(String edit, String figure, double paperSaving, double saving, double cap, List<ValueResult> values) {
    public EditResult {
        values = List.copyOf(values);
    }
}
