package lightning.bench.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import lightning.bench.result.BenchResults;
import lightning.bench.result.BenchRun;
import lightning.bench.result.GrowthCurve;
import lightning.bench.result.SceneResult;

/** Charts of a run as files for documents, which are those of its report. */
public final class DocumentCharts {
    /** Scene with multiple reflections, which separates the accuracy settings. */
    private static final String SCENE = "balls";
    /** Takes a chart by its label from the report: with a description, colors of a light screen, and paper. */
    private static final String EXPORT =
            """
                    const chart = [...document.querySelectorAll("svg.chart")].find(c => c.getAttribute("aria-label") === arguments[0]);
                    if (!chart) {
                      return null;
                    }
                    const paper = document.createElementNS(chart.namespaceURI, "rect");
                    Object.entries({ width: "100%", height: "100%", fill: "#fff" }).forEach(([name, v]) => paper.setAttribute(name, v));
                    const text = document.createElementNS(chart.namespaceURI, "desc");
                    text.textContent = arguments[1];
                    const file = chart.cloneNode(true);
                    file.prepend(text, paper);
                    Object.entries({ "font-family": "sans-serif", "font-size": 11 }).forEach(([name, v]) => file.setAttribute(name, v));
                    const style = getComputedStyle(document.documentElement);
                    return new XMLSerializer().serializeToString(file).replace(/var\\((--\\w+)\\)/g, (all, name) => style.getPropertyValue(name).trim())
                      .replaceAll("><", ">\\n<") + "\\n";""";

    private DocumentCharts() {}

    /** Returns the labels of charts in the report by file name: savings and accuracy settings of one scene, and growth curves. */
    public static Map<String, String> labels(BenchResults results) {
        Map<String, String> labels = new LinkedHashMap<>();
        results.scenes().stream().filter(s -> s.scene().equals(SCENE) && !s.edits().isEmpty()).findFirst().ifPresent(scene -> {
            labels.put("results-savings.svg", "Time of each edit, compared with the paper, " + title(scene));
            labels.put("results-ladder.svg", "Error against time of each accuracy setting, " + title(scene));
        });
        for (GrowthCurve growth : results.growth()) {
            labels.put("results-growth-" + growth.along() + ".svg", "Time against " + growth.along());
        }
        return labels;
    }

    private static String title(SceneResult scene) {
        return scene.scene() + ", " + scene.width() + " × " + scene.height();
    }

    /**
     * Draws charts in a browser; skips the test if there is none.
     *
     * @param labels labels in the report by file name
     * @param folder for the report
     * @return SVG by file name; each names the measured build
     */
    public static Map<String, String> draw(BenchResults results, Map<String, String> labels, Path folder) throws IOException {
        BenchRun run = results.run();
        Map<String, String> charts = new LinkedHashMap<>();
        try (ReportPage page = ReportPage.open(results, folder)) {
            labels.forEach((file, label) -> {
                Object svg = page.run(EXPORT, label, label + ", build " + run.commit() + ", " + run.date());
                if (svg == null) {
                    throw new AssertionError("the report has no chart " + label);
                }
                charts.put(file, svg.toString());
            });
        }
        return charts;
    }
}
