package lightning.bench.report;

import java.awt.Shape;
import java.util.List;
import java.util.function.DoubleFunction;
import lightning.render.measure.ParetoFront;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYErrorRenderer;
import org.jfree.chart.renderer.xy.XYStepRenderer;
import org.jfree.data.xy.XYIntervalSeries;
import org.jfree.data.xy.XYIntervalSeriesCollection;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;

/**
 * Chart of error against time on logarithmic axes: a point per setting, quartiles of time as whiskers, and the Pareto front. Images without
 * any error have a separate line.
 */
final class ParetoChart {
    /** Error from which axes start if all images are equal. */
    private static final double MIN_ERROR = 1e-7;

    private ParetoChart() {}

    /**
     * Setting with its time in milliseconds and its error, ≥ 0.
     *
     * @param label  text next to the point
     * @param filled whether the shape is filled
     */
    record Point(String label, PlotColor ink, Shape shape, boolean filled, double lower, double median, double upper, double error) {
        private boolean isPlausible() {
            return ChartRange.isPlausible(lower) && lower <= median && median <= upper && ChartRange.isPlausible(upper)
                    && ChartRange.isPlausibleOrZero(error);
        }
    }

    /** @param errorLabel label of a vertical tick other than 0 */
    static String svg(String label, List<Point> measured, int width, int height, DoubleFunction<String> errorLabel) {
        List<Point> points = measured.stream().filter(Point::isPlausible).toList();
        double minError = points.stream().mapToDouble(Point::error).filter(e -> e > 0).min().orElse(MIN_ERROR);
        double maxError = points.stream().mapToDouble(Point::error).filter(Double::isFinite).max().orElse(1);
        boolean hasZero = points.isEmpty() || points.stream().anyMatch(p -> p.error == 0);
        double zero = hasZero ? Math.pow(10, Math.floor(Math.log10(minError)) - 1) : minError / 1.2;
        double top = hasZero ? 3 * Math.max(maxError, 10 * zero) : 1.6 * maxError;
        double fastest = points.stream().mapToDouble(Point::lower).min().orElse(1);
        double slowest = points.stream().mapToDouble(Point::upper).max().orElse(10);
        XYPlot plot = PlotStyle.xy(new DecadeAxis(fastest / 1.6, slowest * 2.2, NumberText::tick),
                new DecadeAxis(hasZero ? zero / 2.4 : zero / 1.4, top, at -> hasZero && at < 1.5 * zero ? "0" : errorLabel.apply(at)));
        plot.setDataset(0, front(points, zero, top));
        plot.setRenderer(0, frontRenderer());
        plot.setDataset(1, settings(points, zero, top));
        plot.setRenderer(1, pointRenderer(points));
        PointLabels labels = new PointLabels(false);
        points.forEach(p -> labels.add(p.median, chartError(p.error, zero, top), p.label, PlotColor.TEXT.color()));
        plot.addAnnotation(labels);
        return ChartSvg.of(PlotStyle.chart(plot), width, height, label);
    }

    private static double chartError(double error, double zero, double top) {
        return error == 0 ? zero : Math.min(error, top);
    }

    private static XYSeriesCollection front(List<Point> points, double zero, double top) {
        XYSeries front = new XYSeries("front");
        ParetoFront.of(points, Point::median, Point::error).forEach(p -> front.add(p.median, chartError(p.error, zero, top)));
        return new XYSeriesCollection(front);
    }

    private static XYIntervalSeriesCollection settings(List<Point> points, double zero, double top) {
        XYIntervalSeriesCollection settings = new XYIntervalSeriesCollection();
        for (int i = 0; i < points.size(); i++) {
            Point p = points.get(i);
            XYIntervalSeries series = new XYIntervalSeries(i);
            double y = chartError(p.error, zero, top);
            series.add(p.median, p.lower, p.upper, y, y, y);
            settings.addSeries(series);
        }
        return settings;
    }

    private static XYStepRenderer frontRenderer() {
        XYStepRenderer renderer = new XYStepRenderer();
        renderer.setSeriesPaint(0, PlotColor.MUTED.color());
        renderer.setSeriesStroke(0, PlotStyle.DASHES);
        renderer.setDefaultShapesVisible(false);
        return renderer;
    }

    private static XYErrorRenderer pointRenderer(List<Point> points) {
        XYErrorRenderer renderer = new XYErrorRenderer();
        renderer.setDrawYError(false);
        renderer.setErrorStroke(PlotStyle.HAIRLINE);
        renderer.setCapLength(4);
        for (int i = 0; i < points.size(); i++) {
            Point p = points.get(i);
            renderer.setSeriesPaint(i, p.ink.color());
            renderer.setSeriesShape(i, p.shape);
            renderer.setSeriesShapesFilled(i, p.filled);
            renderer.setSeriesStroke(i, PlotStyle.LINE);
        }
        return renderer;
    }
}
