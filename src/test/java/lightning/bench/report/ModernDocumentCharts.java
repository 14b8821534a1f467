package lightning.bench.report;

import java.util.LinkedHashMap;
import java.util.Map;
import lightning.bench.result.BenchResults;
import lightning.bench.result.ModernScene;

/** Charts of the modern set as files for documents. */
public final class ModernDocumentCharts {
    private ModernDocumentCharts() {}

    /** Returns the labels of charts in the report by file name. */
    public static Map<String, String> labels(BenchResults results) {
        Map<String, String> labels = new LinkedHashMap<>();
        results.modern().stream().filter(scene -> !scene.curves().isEmpty())
                .forEach(scene -> labels.put(fileName(scene), "Error against time (ms), " + scene.scene()));
        return labels;
    }

    static String fileName(ModernScene scene) {
        return "modern-" + scene.scene().replaceAll("[^\\p{Alnum}_-]", "_") + ".svg";
    }
}
