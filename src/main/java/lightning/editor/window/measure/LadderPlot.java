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
import lightning.base.text.Texts;
import lightning.bench.accuracy.Ladder;
import lightning.bench.accuracy.Rung;

/**
 * Error against time: each grade is a number, the one that it has in the table, and stands on its place. The best are low
 * and at the left. Grades that would hide each other share one label.
 */
final class LadderPlot extends ScatterChart<Number, Number> {
    /** Grades nearer than this share of the chart hide each other. */
    private static final double NEAR = 0.1;
    /** The part of the chart, beyond the largest values, that is left free. */
    private static final double FREE = 1.12;
    /** How far a label stands above its place, pixels. */
    private static final double RISE = -9;

    LadderPlot() {
        super(axis("milliseconds"), axis(Texts.of("root mean square error, linear")));
        setId("ladder-chart");
        setAccessibleText(Texts.of("Error of each grade against its time"));
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
        // The axis's own would write in the default locale.
        axis.setTickLabelFormatter(new NumberStringConverter(Locale.ROOT, "#,##0.######"));
        return axis;
    }

    void show(Ladder ladder) {
        double longest = ladder.rungs().stream().mapToDouble(LadderPlot::time).max().orElse(1);
        double largest = ladder.rungs().stream().mapToDouble(LadderPlot::error).max().orElse(1);
        var points = new XYChart.Series<Number, Number>();
        for (List<Rung> group : groups(ladder.rungs(), NEAR * longest, NEAR * largest)) {
            var label = new Label(group.stream().map(r -> String.valueOf(r.grade().ordinal() + 1)).collect(Collectors.joining(" ")));
            label.setMinWidth(Region.USE_PREF_SIZE);
            label.setTranslateY(RISE);
            // The chart cuts what is left of its axis off.
            label.translateXProperty().bind(label.layoutXProperty().map(x -> Math.max(0, -x.doubleValue())));
            points.getData().add(point(mean(group, LadderPlot::time), mean(group, LadderPlot::error), label));
        }
        var corner = new Region();
        corner.setVisible(false);
        points.getData().add(point(FREE * longest, FREE * largest, corner));
        getData().setAll(List.of(points));
    }

    private static XYChart.Data<Number, Number> point(double x, double y, Region node) {
        var point = new XYChart.Data<Number, Number>(x, y);
        point.setNode(node);
        return point;
    }

    /** Each grade with those that are as near to the first of them. */
    static List<List<Rung>> groups(List<Rung> rungs, double nearTime, double nearError) {
        List<List<Rung>> groups = new ArrayList<>();
        for (Rung rung : rungs) {
            groups.stream().filter(g -> Math.abs(time(g.getFirst()) - time(rung)) <= nearTime
                    && Math.abs(error(g.getFirst()) - error(rung)) <= nearError).findFirst()
                    .ifPresentOrElse(g -> g.add(rung), () -> groups.add(new ArrayList<>(List.of(rung))));
        }
        return groups;
    }

    private static double mean(List<Rung> rungs, ToDoubleFunction<Rung> value) {
        return rungs.stream().mapToDouble(value).average().orElseThrow();
    }

    private static double time(Rung rung) {
        return rung.time().median();
    }

    private static double error(Rung rung) {
        return rung.error().rmse();
    }
}
