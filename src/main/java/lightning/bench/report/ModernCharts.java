package lightning.bench.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.bench.result.BenchResults;
import lightning.bench.result.ErrorCurve;
import lightning.bench.result.ModernScene;

/** Charts of time against error of the modern set. */
public final class ModernCharts {
    private static final int WIDTH = 560;
    private static final int HEIGHT = 260;

    private ModernCharts() {}

    /** Returns the charts as files for documents, by file name; each names the measured build. */
    public static Map<String, String> of(BenchResults results) {
        Map<String, String> charts = new LinkedHashMap<>();
        results.modern().stream().filter(scene -> !scene.curves().isEmpty()).forEach(scene -> charts.put(fileName(scene),
                ChartSvg.file(svg(scene), scene.scene() + ", build " + results.run().commit() + ", " + results.run().date())));
        return charts;
    }

    static String fileName(ModernScene scene) {
        return "modern-" + scene.scene().replaceAll("[^\\p{Alnum}_-]", "_") + ".svg";
    }

    /** Returns the chart of a scene: error, in percent of white, against milliseconds; a line per program. */
    static String svg(ModernScene scene) {
        List<CurveChart.Curve> curves = new ArrayList<>();
        for (ErrorCurve curve : scene.curves()) {
            List<double[]> points = curve.points().stream().map(point -> new double[] {point.time().median(), point.error()})
                    .filter(point -> ChartRange.isPlausible(point[0]) && ChartRange.isPlausibleOrZero(point[1]))
                    .sorted(Comparator.comparingDouble(point -> point[0])).toList();
            curves.add(new CurveChart.Curve(curve.program(), PlotColor.of(curves.size()), false, points));
        }
        return CurveChart.svg("Error against time (ms), " + scene.scene(), curves, WIDTH, HEIGHT, NumberText::tick,
                error -> NumberText.tick(100 * error) + " %");
    }
}
