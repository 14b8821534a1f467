package lightning.editor.window.measure;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javafx.css.PseudoClass;
import javafx.scene.Node;
import javafx.scene.chart.LineChart;
import javafx.scene.chart.NumberAxis;
import javafx.scene.chart.XYChart;
import javafx.scene.control.Label;
import javafx.scene.control.SelectionModel;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.util.StringConverter;
import lightning.base.text.Messages;
import lightning.editor.window.model.StatusText;
import lightning.editor.window.widget.PercentText;
import lightning.render.measure.SettingSweep;

/**
 * Plot of mean difference against time, a point for each setting of an effect. A dashed line marks the Pareto front: no other setting is
 * both faster and more accurate. A click on a point selects it.
 */
final class SettingPlot extends LineChart<Number, Number> {
    private static final PseudoClass SELECTED = PseudoClass.getPseudoClass("selected");
    private static final PseudoClass OPTIMAL = PseudoClass.getPseudoClass("optimal");
    /** Factor from the shortest and longest time to the ends of the axis. */
    private static final double TIME_MARGIN = 1.7;
    private static final double LABEL_MARGIN = 1.08;
    private static final double MIN_MILLISECONDS = 0.01;
    /** Place of a label relative to the upper left of its point, pixels. */
    private static final double LABEL_X = 9;
    private static final double LABEL_Y = -13;

    private final SelectionModel<SettingSweep.Point> selection;
    private final Map<SettingSweep.Point, Region> symbols = new HashMap<>();

    /** @param selection  selected setting, which the plot marks and sets */
    SettingPlot(SelectionModel<SettingSweep.Point> selection) {
        super(new TimeAxis(), differenceAxis());
        this.selection = selection;
        getXAxis().setLabel(Messages.tr("Time"));
        setId("setting-chart");
        setAccessibleText(Messages.tr("Difference against time of each setting"));
        setLegendVisible(false);
        setAnimated(false);
        setAxisSortingPolicy(SortingPolicy.NONE);
        getStyleClass().addAll("ladder-chart", "setting-chart");
        selection.selectedItemProperty().subscribe(
                selected -> symbols.forEach((point, symbol) -> symbol.pseudoClassStateChanged(SELECTED, point.equals(selected))));
    }

    private static NumberAxis differenceAxis() {
        var axis = new NumberAxis();
        axis.setLabel(Messages.tr("Mean difference"));
        axis.setForceZeroInRange(true);
        axis.setAnimated(false);
        axis.setMinorTickVisible(false);
        axis.setTickLabelFormatter(new StringConverter<>() {
            @Override
            public String toString(Number value) {
                return PercentText.format(value.doubleValue());
            }

            @Override
            public Number fromString(String text) {
                throw new UnsupportedOperationException("axes only show values");
            }
        });
        return axis;
    }

    /** Shows the settings that fit into memory. */
    void show(SettingSweep sweep) {
        symbols.clear();
        List<SettingSweep.Point> fitting = sweep.points().stream().filter(SettingSweep.Point::fits).toList();
        if (fitting.isEmpty()) {
            getData().clear();
            return;
        }
        setBounds(fitting);
        List<SettingSweep.Point> front = sweep.front();
        var settings = new XYChart.Series<Number, Number>();
        for (SettingSweep.Point point : fitting) {
            Region symbol = symbol(point);
            symbol.pseudoClassStateChanged(OPTIMAL, front.contains(point));
            symbol.pseudoClassStateChanged(SELECTED, point.equals(selection.getSelectedItem()));
            symbols.put(point, symbol);
            settings.getData().add(data(time(point), point.meanDifference(), symbol));
        }
        // Keeps the uppermost label below the edge, where the chart clips.
        double largest = fitting.stream().mapToDouble(SettingSweep.Point::meanDifference).max().orElseThrow();
        settings.getData().add(data(time(fitting.getFirst()), LABEL_MARGIN * largest, hidden()));
        getData().setAll(List.of(steps(front), settings));
    }

    private void setBounds(List<SettingSweep.Point> points) {
        var times = (TimeAxis) getXAxis();
        times.setAutoRanging(false);
        times.setLowerBound(points.stream().mapToDouble(SettingPlot::time).min().orElseThrow() / TIME_MARGIN);
        times.setUpperBound(points.stream().mapToDouble(SettingPlot::time).max().orElseThrow() * TIME_MARGIN);
    }

    /** Returns the line of the least difference that each time buys. */
    private static XYChart.Series<Number, Number> steps(List<SettingSweep.Point> front) {
        var steps = new XYChart.Series<Number, Number>();
        for (SettingSweep.Point point : front) {
            if (!steps.getData().isEmpty()) {
                steps.getData().add(data(time(point), steps.getData().getLast().getYValue().doubleValue(), hidden()));
            }
            steps.getData().add(data(time(point), point.meanDifference(), hidden()));
        }
        return steps;
    }

    private static double time(SettingSweep.Point point) {
        return Math.max(MIN_MILLISECONDS, point.milliseconds());
    }

    private static XYChart.Data<Number, Number> data(double x, double y, Node node) {
        var data = new XYChart.Data<Number, Number>(x, y);
        data.setNode(node);
        return data;
    }

    private static Node hidden() {
        var node = new Region();
        node.setVisible(false);
        return node;
    }

    private Region symbol(SettingSweep.Point point) {
        var dot = new StackPane();
        dot.setId("setting-point-" + SettingText.id(point.setting()));
        var label = new Label(SettingText.label(point.setting()));
        // Takes no place, so that the point stays where it is measured.
        label.setManaged(false);
        label.setMouseTransparent(true);
        label.relocate(LABEL_X, LABEL_Y);
        label.autosize();
        label.needsLayoutProperty().subscribe(label::autosize);
        dot.getChildren().add(label);
        dot.setOnMouseClicked(_ -> selection.select(point));
        String text = Messages.tr("{0}: {1}, difference {2}", SettingText.text(point.setting()), StatusText.time(point.milliseconds()),
                PercentText.format(point.meanDifference()));
        dot.setAccessibleText(text);
        Tooltip.install(dot, new Tooltip(text));
        return dot;
    }
}
