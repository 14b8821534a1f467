package lightning.bench.report;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.bench.result.BenchResults;
import lightning.bench.result.IndirectAccuracy;
import lightning.bench.result.IndirectGrowth;
import lightning.bench.result.ReflectionAccuracy;
import lightning.bench.result.SoftShadowAccuracy;
import lightning.render.measure.ParetoFront;

/** Charts of indirect light as files for documents. */
public final class IndirectDocumentCharts {
    static final String BOUNCES = "indirect-bounces.svg";

    private IndirectDocumentCharts() {}

    /** Returns the charts as files for documents, by file name; each names the measured build. */
    public static Map<String, String> of(BenchResults results) {
        Map<String, String> charts = new LinkedHashMap<>();
        String build = "build " + results.run().commit() + ", " + results.run().date();
        results.indirect().accuracy()
                .forEach(scene -> charts.put(fileName(scene), ChartSvg.file(IndirectCharts.svg(scene), scene.scene() + ", " + build)));
        if (!results.indirect().accuracy().isEmpty()) {
            charts.put(BOUNCES, ChartSvg.file(IndirectCharts.bounces(results.indirect()), build));
        }
        results.indirect().reflections().stream().filter(scene -> !scene.points().isEmpty())
                .forEach(scene -> charts.put(fileName(scene), ChartSvg.file(IndirectCharts.svg(scene), scene.scene() + ", " + build)));
        results.indirect().softShadows()
                .forEach(scene -> charts.put(fileName(scene), ChartSvg.file(IndirectCharts.svg(scene), scene.scene() + ", " + build)));
        results.indirect().growth().forEach(growth -> charts.put(fileName(growth), ChartSvg.file(IndirectCharts.svg(growth), build)));
        return charts;
    }

    static String fileName(IndirectAccuracy scene) {
        return "indirect-error-" + word(scene.scene()) + ".svg";
    }

    static String fileName(ReflectionAccuracy scene) {
        return "indirect-reflections-" + word(scene.scene()) + ".svg";
    }

    static String fileName(SoftShadowAccuracy scene) {
        return "indirect-shadows-" + word(scene.scene()) + ".svg";
    }

    static String fileName(IndirectGrowth growth) {
        return "indirect-growth-" + word(growth.along()) + ".svg";
    }

    private static String word(String text) {
        return text.replaceAll("[^\\p{Alnum}]+", "-");
    }

    /** Returns the settings on the Pareto front, fastest first. */
    static List<IndirectAccuracy.Point> front(IndirectAccuracy scene) {
        return ParetoFront.of(scene.grid(), point -> point.time().median(), point -> point.error().mean());
    }
}
