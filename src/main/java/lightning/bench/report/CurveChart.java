package lightning.bench.report;

import java.awt.geom.Ellipse2D;
import java.util.List;
import java.util.function.DoubleFunction;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;

/** Chart of lines on logarithmic axes, each labeled at its end. Values of 0 have a separate line. */
final class CurveChart {
    /** Line through points {@code {x, y}}, x ascending, both ≥ 0; dashed for bounds; its name may be empty. */
    record Curve(String name, PlotColor ink, boolean dashed, List<double[]> points) {
        double[] last() {
            return points.getLast();
        }
    }

    private static final int AXIS = 50;
    private static final int NAME_GAP = 14;

    private CurveChart() {}

    /**
     * @param xLabel label of a horizontal tick
     * @param yLabel label of a vertical tick
     */
    static String svg(String label, List<Curve> all, int width, int height, DoubleFunction<String> xLabel, DoubleFunction<String> yLabel) {
        List<Curve> curves = all.stream().filter(c -> !c.points.isEmpty()).toList();
        double left = curves.stream().flatMap(c -> c.points.stream()).mapToDouble(p -> p[0]).filter(x -> x > 0).min().orElse(1);
        double right = Math.max(curves.stream().mapToDouble(c -> c.last()[0]).max().orElse(10), 1.5 * left);
        double low = curves.stream().flatMap(c -> c.points.stream()).mapToDouble(p -> p[1]).filter(y -> y > 0).min().orElse(1e-7);
        double high = Math.max(2 * low, curves.stream().flatMap(c -> c.points.stream()).mapToDouble(p -> p[1]).max().orElse(1));
        boolean hasZeroY = curves.stream().flatMap(c -> c.points.stream()).anyMatch(p -> p[1] == 0);
        double zero = hasZeroY ? Math.pow(10, Math.floor(Math.log10(low)) - 1) : low / 1.6;
        boolean hasZeroX = curves.stream().flatMap(c -> c.points.stream()).anyMatch(p -> p[0] == 0);
        double start = hasZeroX ? left / 2 : left;
        double nameWidth = curves.stream().mapToDouble(c -> ChartSvg.widthOf(c.name)).max().orElse(0) + NAME_GAP;
        DecadeAxis bottom = new DecadeAxis(start / 1.15, right * Math.pow(right / start, nameWidth / (width - nameWidth - AXIS)),
                x -> x > 1.01 * right ? "" : hasZeroX && x < 0.9 * left ? "0" : xLabel.apply(x));
        XYPlot plot = PlotStyle.xy(bottom,
                new DecadeAxis(hasZeroY ? zero / 1.6 : zero, high * 2, y -> hasZeroY && y < 1.5 * zero ? "0" : yLabel.apply(y)));
        XYSeriesCollection lines = new XYSeriesCollection();
        XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer();
        PointLabels labels = new PointLabels(true);
        for (int i = 0; i < curves.size(); i++) {
            Curve curve = curves.get(i);
            XYSeries line = new XYSeries(i);
            curve.points.forEach(p -> line.add(p[0] > 0 ? p[0] : start, p[1] > 0 ? p[1] : zero));
            lines.addSeries(line);
            renderer.setSeriesPaint(i, curve.ink.color());
            renderer.setSeriesStroke(i, curve.dashed ? PlotStyle.DASHES : PlotStyle.LINE);
            renderer.setSeriesShape(i, new Ellipse2D.Double(-2.25, -2.25, 4.5, 4.5));
            renderer.setSeriesShapesVisible(i, !curve.dashed);
            if (curve.name.isEmpty()) {
                renderer.setSeriesStroke(i, PlotStyle.HAIRLINE);
                renderer.setSeriesShapesVisible(i, false);
                continue;
            }
            labels.add(curve.last()[0], curve.last()[1] > 0 ? curve.last()[1] : zero, curve.name, curve.ink.color());
        }
        plot.setDataset(lines);
        plot.setRenderer(renderer);
        plot.addAnnotation(labels);
        return ChartSvg.of(PlotStyle.chart(plot), width, height, label);
    }
}
