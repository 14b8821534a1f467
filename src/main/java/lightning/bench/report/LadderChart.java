package lightning.bench.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import lightning.bench.accuracy.Grade;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYErrorRenderer;
import org.jfree.chart.renderer.xy.XYStepRenderer;
import org.jfree.data.xy.XYIntervalSeries;
import org.jfree.data.xy.XYIntervalSeriesCollection;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;

/**
 * Error against time on logarithmic axes, one point for each grade of accuracy, quartiles of time as whiskers, and the front
 * of Pareto: the grades than which no other is both faster and closer. Pictures without any error have a line of their own.
 */
final class LadderChart {
    /** Where all pictures are equal. */
    private static final double LEAST_ERROR = 1e-7;

    /** One grade: its time in milliseconds, and its error, ≥ 0. */
    record Point(Grade grade, double lower, double median, double upper, double error) {
        private boolean isPlausible() {
            return Charts.plausible(lower) && lower <= median && median <= upper && Charts.plausible(upper)
                    && Charts.plausibleOrZero(error);
        }
    }

    private LadderChart() {}

    static String svg(String label, List<Point> measured, int width, int height) {
        List<Point> points = measured.stream().filter(Point::isPlausible).toList();
        double least = points.stream().mapToDouble(Point::error).filter(e -> e > 0).min().orElse(LEAST_ERROR);
        double most = points.stream().mapToDouble(Point::error).filter(Double::isFinite).max().orElse(1);
        double zero = Math.pow(10, Math.floor(Math.log10(least)) - 1);
        double top = 3 * Math.max(most, 10 * zero);
        double fastest = points.stream().mapToDouble(Point::lower).min().orElse(1);
        double slowest = points.stream().mapToDouble(Point::upper).max().orElse(10);
        XYPlot plot = PlotLook.xy(new DecadeAxis(fastest / 1.6, slowest * 2.2, Numbers::tick),
                new DecadeAxis(zero / 2.4, top, at -> at < 1.5 * zero ? "0" : Numbers.power((int) Math.round(Math.log10(at)))));
        plot.setDataset(0, front(points, zero, top));
        plot.setRenderer(0, steps());
        plot.setDataset(1, grades(points, zero, top));
        plot.setRenderer(1, dots(points));
        PointLabels labels = new PointLabels(false);
        points.forEach(p -> labels.add(p.median, shown(p.error, zero, top), p.grade.label(), Ink.TEXT.color()));
        plot.addAnnotation(labels);
        return ChartSvg.of(PlotLook.chart(plot), width, height, label);
    }

    /** The grades than which none is as fast and closer, or faster and as close: the fastest first. */
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

    private static double shown(double error, double zero, double top) {
        return error == 0 ? zero : Math.min(error, top);
    }

    private static XYSeriesCollection front(List<Point> points, double zero, double top) {
        XYSeries front = new XYSeries("front");
        paretoFront(points).forEach(p -> front.add(p.median, shown(p.error, zero, top)));
        return new XYSeriesCollection(front);
    }

    private static XYIntervalSeriesCollection grades(List<Point> points, double zero, double top) {
        XYIntervalSeriesCollection grades = new XYIntervalSeriesCollection();
        for (Point p : points) {
            XYIntervalSeries series = new XYIntervalSeries(p.grade);
            double y = shown(p.error, zero, top);
            series.add(p.median, p.lower, p.upper, y, y, y);
            grades.addSeries(series);
        }
        return grades;
    }

    private static XYStepRenderer steps() {
        XYStepRenderer renderer = new XYStepRenderer();
        renderer.setSeriesPaint(0, Ink.MUTED.color());
        renderer.setSeriesStroke(0, PlotLook.DASHES);
        renderer.setDefaultShapesVisible(false);
        return renderer;
    }

    private static XYErrorRenderer dots(List<Point> points) {
        XYErrorRenderer renderer = new XYErrorRenderer();
        renderer.setDrawYError(false);
        renderer.setErrorStroke(PlotLook.HAIRLINE);
        renderer.setCapLength(4);
        for (int i = 0; i < points.size(); i++) {
            Grade grade = points.get(i).grade;
            renderer.setSeriesPaint(i, Ink.of(grade).color());
            renderer.setSeriesShape(i, PlotLook.shape(grade));
            renderer.setSeriesShapesFilled(i, grade != Grade.EXACT);
            renderer.setSeriesStroke(i, PlotLook.LINE);
        }
        return renderer;
    }
}
