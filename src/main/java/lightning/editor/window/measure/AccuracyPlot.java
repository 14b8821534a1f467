package lightning.editor.window.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import javafx.scene.chart.NumberAxis;
import javafx.scene.chart.ScatterChart;
import javafx.scene.chart.XYChart;
import javafx.scene.control.Label;
import javafx.scene.layout.Region;
import javafx.util.converter.NumberStringConverter;
import lightning.base.text.Messages;
import lightning.render.measure.AccuracySweep;
import lightning.render.measure.SweepPoint;

/** Plot of error against time. Each accuracy setting is labeled with its row number in the table; overlapping labels are merged. */
final class AccuracyPlot extends ScatterChart<Number, Number> {
    /** Labels nearer than this fraction of the plot are merged. */
    private static final double GROUP_DISTANCE = 0.1;
    /** Factor from the largest values to the ends of the axes. */
    private static final double AXIS_MARGIN = 1.12;
    /** Vertical offset of a label from its point, pixels. */
    private static final double LABEL_OFFSET = -9;

    AccuracyPlot() {
        super(axis("milliseconds"), axis(Messages.tr("root mean square error, linear")));
        setId("ladder-chart");
        setAccessibleText(Messages.tr("Error against time of each setting"));
        setLegendVisible(false);
        setAnimated(false);
        getStyleClass().add("ladder-chart");
    }

    private static NumberAxis axis(String title) {
        var axis = new NumberAxis();
        axis.setLabel(title);
        axis.setForceZeroInRange(true);
        axis.setAnimated(false);
        axis.setMinorTickVisible(false);
        // The default formatter uses the default locale.
        axis.setTickLabelFormatter(new NumberStringConverter(Locale.ROOT, "#,##0.######"));
        return axis;
    }

    void show(AccuracySweep sweep) {
        double longest = sweep.points().stream().mapToDouble(AccuracyPlot::time).max().orElse(1);
        double largest = sweep.points().stream().mapToDouble(AccuracyPlot::error).max().orElse(1);
        var points = new XYChart.Series<Number, Number>();
        for (List<SweepPoint> group : groups(sweep.points(), GROUP_DISTANCE * longest, GROUP_DISTANCE * largest)) {
            var label = new Label(group.stream().map(r -> String.valueOf(r.setting().ordinal() + 1)).collect(Collectors.joining(" ")));
            label.setMinWidth(Region.USE_PREF_SIZE);
            label.setTranslateY(LABEL_OFFSET);
            // Keeps labels right of the axis, where the chart clips.
            label.translateXProperty().bind(label.layoutXProperty().map(x -> Math.max(0, -x.doubleValue())));
            points.getData().add(point(mean(group, AccuracyPlot::time), mean(group, AccuracyPlot::error), label));
        }
        var corner = new Region();
        corner.setVisible(false);
        points.getData().add(point(AXIS_MARGIN * longest, AXIS_MARGIN * largest, corner));
        getData().setAll(List.of(points));
    }

    private static XYChart.Data<Number, Number> point(double x, double y, Region node) {
        var point = new XYChart.Data<Number, Number>(x, y);
        point.setNode(node);
        return point;
    }

    /** Groups each setting with the settings near the first of its group. */
    static List<List<SweepPoint>> groups(List<SweepPoint> points, double nearTime, double nearError) {
        List<List<SweepPoint>> groups = new ArrayList<>();
        for (SweepPoint point : points) {
            groups.stream().filter(g -> Math.abs(time(g.getFirst()) - time(point)) <= nearTime
                    && Math.abs(error(g.getFirst()) - error(point)) <= nearError).findFirst()
                    .ifPresentOrElse(g -> g.add(point), () -> groups.add(new ArrayList<>(List.of(point))));
        }
        return groups;
    }

    private static double mean(List<SweepPoint> points, ToDoubleFunction<SweepPoint> value) {
        return points.stream().mapToDouble(value).average().orElseThrow();
    }

    private static double time(SweepPoint point) {
        return point.time().median();
    }

    private static double error(SweepPoint point) {
        return point.error().rmse();
    }
}
