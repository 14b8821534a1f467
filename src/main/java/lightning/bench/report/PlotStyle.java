package lightning.bench.report;

import java.awt.BasicStroke;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import lightning.render.measure.AccuracySetting;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.Axis;
import org.jfree.chart.axis.AxisLocation;
import org.jfree.chart.axis.CategoryAxis;
import org.jfree.chart.axis.CategoryLabelPositions;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.CategoryPlot;
import org.jfree.chart.plot.Plot;
import org.jfree.chart.plot.PlotOrientation;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.ui.RectangleInsets;

/** Style of all charts: no frame, no background, thin grid lines, one text size. */
final class PlotStyle {
    static final BasicStroke HAIRLINE = new BasicStroke(0.75f);
    static final BasicStroke LINE = new BasicStroke(1.75f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    static final BasicStroke DASHES = new BasicStroke(1.25f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, new float[] {4, 3}, 0);

    /** Shapes in the order of the accuracy settings, from the roughest to the full trace. */
    private static final List<Shape> SHAPES = List.of(new Rectangle2D.Double(-4, -4, 8, 8), polygon(0, -5, 5, 4, -5, 4),
            polygon(-6, 0, 0, -3, 6, 0, 0, 3), polygon(-6, -3, 0, 0, 6, -3, 6, 3, 0, 0, -6, 3), polygon(0, -5.5, 5.5, 0, 0, 5.5, -5.5, 0),
            new Ellipse2D.Double(-4, -4, 8, 8), polygon(0, 5, 5, -4, -5, -4), new Ellipse2D.Double(-5, -5, 10, 10),
            new Rectangle2D.Double(-2, -6, 4, 12));

    private PlotStyle() {}

    static JFreeChart chart(Plot plot) {
        plot.setBackgroundPaint(null);
        plot.setOutlineVisible(false);
        plot.setInsets(new RectangleInsets(4, 2, 2, 8));
        plot.setNoDataMessage("no measurements");
        plot.setNoDataMessageFont(ChartSvg.FONT);
        plot.setNoDataMessagePaint(PlotColor.MUTED.color());
        JFreeChart chart = new JFreeChart(null, null, plot, false);
        chart.setBackgroundPaint(null);
        chart.setElementHinting(false);
        chart.setTextAntiAlias(true);
        return chart;
    }

    static XYPlot xy(ValueAxis xAxis, ValueAxis yAxis) {
        XYPlot plot = new XYPlot(null, xAxis, yAxis, null);
        grid(xAxis);
        grid(yAxis);
        plot.setDomainGridlinePaint(PlotColor.GRID.color());
        plot.setRangeGridlinePaint(PlotColor.GRID.color());
        plot.setDomainGridlineStroke(HAIRLINE);
        plot.setRangeGridlineStroke(HAIRLINE);
        plot.setRangeZeroBaselineVisible(false);
        plot.setAxisOffset(RectangleInsets.ZERO_INSETS);
        return plot;
    }

    /** Creates a plot with names on the left and values across. */
    static CategoryPlot rows(ValueAxis values) {
        CategoryAxis names = new CategoryAxis();
        grid(names);
        names.setTickLabelPaint(PlotColor.TEXT.color());
        names.setMaximumCategoryLabelWidthRatio(0.5f);
        names.setCategoryLabelPositions(CategoryLabelPositions.STANDARD);
        names.setLowerMargin(0.005);
        names.setUpperMargin(0.005);
        names.setCategoryMargin(0.16);
        CategoryPlot plot = new CategoryPlot(null, names, values, null);
        plot.setOrientation(PlotOrientation.HORIZONTAL);
        plot.setRangeAxisLocation(AxisLocation.TOP_OR_LEFT);
        plot.setAxisOffset(RectangleInsets.ZERO_INSETS);
        plot.setRangeGridlinePaint(PlotColor.GRID.color());
        plot.setRangeGridlineStroke(HAIRLINE);
        grid(values);
        return plot;
    }

    private static void grid(Axis axis) {
        axis.setAxisLineVisible(false);
        axis.setTickMarksVisible(false);
        axis.setTickLabelFont(ChartSvg.FONT);
        axis.setTickLabelPaint(PlotColor.MUTED.color());
    }

    /** Returns the shape of an accuracy setting, for prints without color. */
    static Shape shape(AccuracySetting setting) {
        return SHAPES.get(setting.ordinal());
    }

    /** Returns the shape of points of a color without a meaning of its own. */
    static Shape shape(int series) {
        return SHAPES.get(series % SHAPES.size());
    }

    private static Shape polygon(double... xy) {
        Path2D path = new Path2D.Double();
        path.moveTo(xy[0], xy[1]);
        for (int i = 2; i < xy.length; i += 2) {
            path.lineTo(xy[i], xy[i + 1]);
        }
        path.closePath();
        return path;
    }
}
