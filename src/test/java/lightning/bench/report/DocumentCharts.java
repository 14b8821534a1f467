package lightning.bench.report;

import java.util.LinkedHashMap;
import java.util.Map;
import lightning.bench.result.BenchResults;
import lightning.bench.result.GrowthCurve;
import lightning.bench.result.SceneResult;

/** Charts of a run as files for documents; each names the measured build. */
public final class DocumentCharts {
    /** Scene with multiple reflections, which separates the accuracy settings. */
    private static final String SCENE = "balls";

    private DocumentCharts() {}

    /** Returns the charts by file name: savings and accuracy settings of one scene, and growth curves. */
    public static Map<String, String> of(BenchResults results) {
        Map<String, String> charts = new LinkedHashMap<>();
        String build = "build " + results.run().commit() + ", " + results.run().date();
        results.scenes().stream().filter(s -> s.scene().equals(SCENE) && !s.edits().isEmpty()).findFirst().ifPresent(scene -> {
            charts.put("results-savings.svg", ChartSvg.file(SceneSection.shares(scene), title(scene, build)));
            charts.put("results-ladder.svg", ChartSvg.file(SceneSection.accuracy(AccuracySummary.of(scene)), title(scene, build)));
        });
        for (GrowthCurve growth : results.growth()) {
            charts.put("results-growth-" + growth.along() + ".svg", ChartSvg.file(CurveSections.growth(growth), build));
        }
        return charts;
    }

    private static String title(SceneResult scene, String build) {
        return SceneSection.title(scene) + ", " + build;
    }
}
