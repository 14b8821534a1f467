package lightning.bench.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import lightning.bench.accuracy.ModernCases;
import lightning.bench.result.IndirectAccuracy;
import lightning.bench.result.IndirectCost;
import lightning.bench.result.IndirectResults;
import lightning.render.measure.IndirectError;

/** Findings of indirect light as sentences with measured values, one per list item. */
final class IndirectFindings {
    private IndirectFindings() {}

    static String list(IndirectResults results) {
        List<String> items = new ArrayList<>();
        List<IndirectCost.Edit> edits = results.costs().stream().flatMap(c -> c.edits().stream()).toList();
        items.add("**Exactness**: of " + edits.size() + " edited images, " + edits.stream().filter(IndirectCost.Edit::equal).count()
                + " were equal to a full trace in every bit.");
        items.add("**Error** of the default settings: mean " + errors(results, IndirectError::mean) + " %, 95th percentile "
                + errors(results, IndirectError::high) + " %, bias " + errors(results, IndirectError::bias) + " %.");
        items.add("**First pass**: indirect light adds " + costs("%.0f", results, IndirectCost::extraMs) + " ms and "
                + costs("%.0f", results, IndirectCost::bytesPerPixel) + " bytes a pixel.");
        for (String edit : List.of(ModernCases.COLOR, ModernCases.POSITION, ModernCases.MATERIAL_COLOR, ModernCases.SHAPE_MOVED)) {
            items.add("**Edit " + edit.replace('-', ' ') + "**: takes " + edits("%.0f", results, edit, (_, e) -> e.time().median())
                    + " ms, of which indirect light adds " + edits("%.0f", results, edit, (_, e) -> e.extraMs())
                    + " ms. A first pass would take "
                    + edits("%.1f", results, edit, (c, e) -> c.first().median() / e.time().median()) + " times as long.");
        }
        return items.stream().map(item -> "- " + item + "\n").collect(Collectors.joining());
    }

    private static String errors(IndirectResults results, ToDoubleFunction<IndirectError> value) {
        return ReportStatements.range("%.1f", results.accuracy().stream().map(IndirectAccuracy::initial).flatMap(Optional::stream)
                .map(point -> 100 * value.applyAsDouble(point.error())));
    }

    private static String costs(String pattern, IndirectResults results, ToDoubleFunction<IndirectCost> value) {
        return ReportStatements.range(pattern, results.costs().stream().map(value::applyAsDouble));
    }

    /** Value of an edit of a scene. */
    private interface EditValue {
        double of(IndirectCost cost, IndirectCost.Edit edit);
    }

    private static String edits(String pattern, IndirectResults results, String name, EditValue value) {
        return ReportStatements.range(pattern, results.costs().stream()
                .flatMap(c -> c.find(name).stream().map(e -> value.of(c, e))));
    }
}
