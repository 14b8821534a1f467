package lightning.bench.report;

import java.util.LinkedHashMap;
import java.util.Map;
import lightning.bench.result.BenchResults;
import lightning.bench.result.ModernScene;

/** Charts of the modern set as files for documents. */
public final class ModernDocumentCharts {
    private ModernDocumentCharts() {}

    /** Returns the charts as files for documents, by file name; each names the measured build. */
    public static Map<String, String> of(BenchResults results) {
        Map<String, String> charts = new LinkedHashMap<>();
        results.modern().stream().filter(scene -> !scene.curves().isEmpty()).forEach(scene -> charts.put(fileName(scene),
                ChartSvg.file(ModernCharts.svg(scene), scene.scene() + ", build " + results.run().commit() + ", " + results.run().date())));
        return charts;
    }

    static String fileName(ModernScene scene) {
        return "modern-" + scene.scene().replaceAll("[^\\p{Alnum}_-]", "_") + ".svg";
    }
}
