package lightning.bench.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import lightning.bench.accuracy.AccuracySetting;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYErrorRenderer;
import org.jfree.chart.renderer.xy.XYStepRenderer;
import org.jfree.data.xy.XYIntervalSeries;
import org.jfree.data.xy.XYIntervalSeriesCollection;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;

/**
 * Chart of error against time on logarithmic axes: a point per accuracy setting, quartiles of time as whiskers, and the Pareto front.
 * Images without any error have a separate line.
 */
final class AccuracyChart {
    /** Error from which axes start if all images are equal. */
    private static final double MIN_ERROR = 1e-7;

    /** Accuracy setting with its time in milliseconds and its error, ≥ 0. */
    record Point(AccuracySetting setting, double lower, double median, double upper, double error) {
        private boolean isPlausible() {
            return ChartRange.isPlausible(lower) && lower <= median && median <= upper && ChartRange.isPlausible(upper)
                    && ChartRange.isPlausibleOrZero(error);
        }
    }

    private AccuracyChart() {}

    static String svg(String label, List<Point> measured, int width, int height) {
        List<Point> points = measured.stream().filter(Point::isPlausible).toList();
        double minError = points.stream().mapToDouble(Point::error).filter(e -> e > 0).min().orElse(MIN_ERROR);
        double maxError = points.stream().mapToDouble(Point::error).filter(Double::isFinite).max().orElse(1);
        double zero = Math.pow(10, Math.floor(Math.log10(minError)) - 1);
        double top = 3 * Math.max(maxError, 10 * zero);
        double fastest = points.stream().mapToDouble(Point::lower).min().orElse(1);
        double slowest = points.stream().mapToDouble(Point::upper).max().orElse(10);
        XYPlot plot = PlotStyle.xy(new DecadeAxis(fastest / 1.6, slowest * 2.2, NumberText::tick),
                new DecadeAxis(zero / 2.4, top, at -> at < 1.5 * zero ? "0" : NumberText.power((int) Math.round(Math.log10(at)))));
        plot.setDataset(0, front(points, zero, top));
        plot.setRenderer(0, frontRenderer());
        plot.setDataset(1, settings(points, zero, top));
        plot.setRenderer(1, pointRenderer(points));
        PointLabels labels = new PointLabels(false);
        points.forEach(p -> labels.add(p.median, chartError(p.error, zero, top), p.setting.label(), PlotColor.TEXT.color()));
        plot.addAnnotation(labels);
        return ChartSvg.of(PlotStyle.chart(plot), width, height, label);
    }

    /** Returns the Pareto-optimal settings, fastest first. */
    static List<Point> paretoFront(List<Point> points) {
        List<Point> front = new ArrayList<>();
        List<Point> byTime = points.stream().sorted(Comparator.comparingDouble(Point::median).thenComparingDouble(Point::error)).toList();
        for (Point p : byTime) {
            if (front.isEmpty() || p.error < front.getLast().error) {
                front.add(p);
            }
        }
        return front;
    }

    private static double chartError(double error, double zero, double top) {
        return error == 0 ? zero : Math.min(error, top);
    }

    private static XYSeriesCollection front(List<Point> points, double zero, double top) {
        XYSeries front = new XYSeries("front");
        paretoFront(points).forEach(p -> front.add(p.median, chartError(p.error, zero, top)));
        return new XYSeriesCollection(front);
    }

    private static XYIntervalSeriesCollection settings(List<Point> points, double zero, double top) {
        XYIntervalSeriesCollection settings = new XYIntervalSeriesCollection();
        for (Point p : points) {
            XYIntervalSeries series = new XYIntervalSeries(p.setting);
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
            AccuracySetting setting = points.get(i).setting;
            renderer.setSeriesPaint(i, PlotColor.of(setting).color());
            renderer.setSeriesShape(i, PlotStyle.shape(setting));
            renderer.setSeriesShapesFilled(i, setting != AccuracySetting.EXACT);
            renderer.setSeriesStroke(i, PlotStyle.LINE);
        }
        return renderer;
    }
}
