package lightning.bench.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import lightning.bench.result.ErrorCurve;
import lightning.bench.result.ModernScene;

/** Charts of time against error of the modern set. */
final class ModernCharts {
    private static final int WIDTH = 560;
    private static final int HEIGHT = 260;

    private ModernCharts() {}

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
