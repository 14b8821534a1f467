package lightning.bench.report;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import lightning.bench.result.IndirectAccuracy;
import lightning.bench.result.IndirectGrowth;
import lightning.bench.result.IndirectResults;
import lightning.bench.result.ReflectionAccuracy;
import lightning.bench.result.SoftShadowAccuracy;
import lightning.bench.result.TimeSamples;

/** Charts of indirect light: error against time with the Pareto front, missing light against time, and growth. */
final class IndirectCharts {
    private static final int WIDTH = 560;
    private static final int HEIGHT = 300;

    private IndirectCharts() {}

    /**
     * Returns the chart of a scene: mean error against the milliseconds of the first pass; a color per number of rays, and the default is
     * filled.
     */
    static String svg(IndirectAccuracy scene) {
        List<Integer> rays = scene.grid().stream().map(IndirectAccuracy.Point::rays).distinct().sorted().toList();
        List<ParetoChart.Point> points = scene.grid().stream().map(point -> new ParetoChart.Point(point.spacing() + ", " + point.rays(),
                PlotColor.of(rays.indexOf(point.rays())), PlotStyle.shape(rays.indexOf(point.rays())), point.usesDefault(),
                point.time().lowerQuartile(),
                point.time().median(), point.time().upperQuartile(), point.error().mean())).toList();
        return ParetoChart.svg("Mean error of indirect light against time (ms), " + scene.scene(), points, WIDTH, HEIGHT,
                IndirectCharts::percent);
    }

    /** Returns the chart of a scene's blurred reflections: mean error against the milliseconds of the first pass; the default is filled. */
    static String svg(ReflectionAccuracy scene) {
        List<ParetoChart.Point> points =
                scene.points().stream().map(point -> point(point.rays(), point.usesDefault(), point.time(), point.mean())).toList();
        return ParetoChart.svg("Mean error of blurred reflections against time (ms), " + scene.scene(), points, WIDTH, HEIGHT,
                IndirectCharts::percent);
    }

    /** Returns the chart of a scene's area lights: mean error against the milliseconds of the first pass; the default is filled. */
    static String svg(SoftShadowAccuracy scene) {
        List<ParetoChart.Point> points =
                scene.points().stream().map(point -> point(point.samples(), point.usesDefault(), point.time(), point.mean())).toList();
        return ParetoChart.svg("Mean error of area lights against time (ms), " + scene.scene(), points, WIDTH, HEIGHT,
                IndirectCharts::percent);
    }

    private static ParetoChart.Point point(int label, boolean isFilled, TimeSamples time, double error) {
        return new ParetoChart.Point(Integer.toString(label), PlotColor.OURS, PlotStyle.shape(0), isFilled, time.lowerQuartile(),
                time.median(), time.upperQuartile(), error);
    }

    /** Returns the chart of the missing share of light against the added milliseconds; a line per scene. */
    static String bounces(IndirectResults results) {
        List<CurveChart.Curve> curves = new ArrayList<>();
        for (IndirectAccuracy scene : results.accuracy()) {
            List<double[]> points = scene.byBounces().stream().map(point -> new double[] {point.bounces(), point.error().missing()})
                    .filter(point -> ChartRange.isPlausible(point[0]) && ChartRange.isPlausible(point[1])).toList();
            curves.add(new CurveChart.Curve(scene.scene(), PlotColor.of(curves.size()), false, points));
        }
        return CurveChart.svg("Missing light against bounces", curves, WIDTH, HEIGHT, NumberText::tick, IndirectCharts::percent);
    }

    /** Returns the chart of a growth curve: milliseconds against its dimension. */
    static String svg(IndirectGrowth growth) {
        List<CurveChart.Curve> curves = List.of(
                curve("first pass, added", PlotColor.OURS, growth, IndirectGrowth.Point::extraMs),
                curve("moved light", PlotColor.RED, growth, point -> point.position().median()),
                curve("intensity", PlotColor.GREEN, growth, point -> point.intensity().median()));
        return CurveChart.svg("Time (ms) against " + growth.along(), curves, WIDTH, HEIGHT, NumberText::tick, NumberText::tick);
    }

    private static CurveChart.Curve curve(String name, PlotColor ink, IndirectGrowth growth, ToDoubleFunction<IndirectGrowth.Point> value) {
        return new CurveChart.Curve(name, ink, false, growth.points().stream()
                .map(point -> new double[] {point.at(), value.applyAsDouble(point)})
                .filter(point -> ChartRange.isPlausible(point[0]) && ChartRange.isPlausible(point[1]))
                .sorted((a, b) -> Double.compare(a[0], b[0])).toList());
    }

    private static String percent(double share) {
        return NumberText.tick(100 * share) + " %";
    }
}
