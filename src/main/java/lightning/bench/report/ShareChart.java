package lightning.bench.report;

import java.awt.BasicStroke;
import java.text.NumberFormat;
import java.util.List;
import java.util.Locale;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnit;
import org.jfree.chart.labels.CategoryItemLabelGenerator;
import org.jfree.chart.labels.ItemLabelAnchor;
import org.jfree.chart.labels.ItemLabelPosition;
import org.jfree.chart.labels.StandardCategoryItemLabelGenerator;
import org.jfree.chart.plot.CategoryPlot;
import org.jfree.chart.plot.DatasetRenderingOrder;
import org.jfree.chart.plot.ValueMarker;
import org.jfree.chart.renderer.category.BarRenderer;
import org.jfree.chart.renderer.category.LevelRenderer;
import org.jfree.chart.renderer.category.StandardBarPainter;
import org.jfree.chart.ui.TextAnchor;
import org.jfree.data.category.CategoryDataset;
import org.jfree.data.category.DefaultCategoryDataset;
import org.jspecify.annotations.Nullable;

/** Bar chart of each edit's time relative to the full trace, with the paper's values for comparison. */
final class ShareChart {
    private static final int WIDTH = 550;
    private static final int ROW = 44;
    private static final int AXIS = 26;
    /** Approximate number of ticks, at steps of 1, 2 or 5 times a power of ten. */
    private static final int TICKS = 6;

    /**
     * Bars of one edit, in percent of the full trace's time; NaN if missing.
     *
     * @param paper value of the paper
     * @param ours  value at the default setting
     * @param stale value without updated reflections
     * @param min   limit from ray counts and memory
     */
    record Bar(String name, double paper, double ours, double stale, double min) {}

    private ShareChart() {}

    static String svg(String label, List<Bar> bars) {
        DefaultCategoryDataset shares = new DefaultCategoryDataset();
        DefaultCategoryDataset minShares = new DefaultCategoryDataset();
        double maxPercent = 100;
        for (Bar bar : bars) {
            put(shares, bar.paper, "paper", bar.name);
            put(shares, bar.ours, "ours", bar.name);
            put(shares, bar.stale, "stale", bar.name);
            put(minShares, Double.NaN, "paper", bar.name);
            put(minShares, bar.min, "ours", bar.name);
            put(minShares, Double.NaN, "stale", bar.name);
            maxPercent = Math.max(maxPercent, Math.max(nonNaN(bar.paper), Math.max(nonNaN(bar.ours), nonNaN(bar.stale))));
        }
        NumberAxis axis = new NumberAxis();
        axis.setRange(0, maxPercent * 1.2);
        axis.setTickUnit(new NumberTickUnit(unit(maxPercent), NumberFormat.getIntegerInstance(Locale.ROOT)));
        CategoryPlot plot = PlotStyle.rows(axis);
        plot.setDataset(0, shares);
        plot.setRenderer(0, bars());
        plot.setDataset(1, minShares);
        plot.setRenderer(1, ticks());
        plot.setDatasetRenderingOrder(DatasetRenderingOrder.FORWARD);
        plot.addRangeMarker(new ValueMarker(100, PlotColor.MUTED.color(), PlotStyle.HAIRLINE));
        return ChartSvg.of(PlotStyle.chart(plot), WIDTH, AXIS + ROW * bars.size(), label);
    }

    private static double unit(double maxPercent) {
        double decade = Math.pow(10, Math.floor(Math.log10(maxPercent / TICKS)));
        double steps = maxPercent / TICKS / decade;
        return decade * (steps > 5 ? 10 : steps > 2 ? 5 : steps > 1 ? 2 : 1);
    }

    private static BarRenderer bars() {
        BarRenderer renderer = new BarRenderer();
        renderer.setBarPainter(new StandardBarPainter());
        renderer.setShadowVisible(false);
        renderer.setItemMargin(0.08);
        renderer.setSeriesPaint(0, PlotColor.PAPER.color());
        renderer.setSeriesPaint(1, PlotColor.OURS.color());
        renderer.setSeriesPaint(2, PlotColor.SKY.color());
        renderer.setDefaultItemLabelGenerator(new ShareLabels());
        renderer.setDefaultItemLabelFont(ChartSvg.FONT);
        renderer.setDefaultItemLabelPaint(PlotColor.TEXT.color());
        renderer.setDefaultItemLabelsVisible(true);
        renderer.setDefaultPositiveItemLabelPosition(new ItemLabelPosition(ItemLabelAnchor.OUTSIDE3, TextAnchor.CENTER_LEFT));
        return renderer;
    }

    /** Draws a line across our bar at its limit. */
    private static LevelRenderer ticks() {
        LevelRenderer renderer = new LevelRenderer();
        renderer.setItemMargin(0.08);
        renderer.setDefaultPaint(PlotColor.TEXT.color());
        renderer.setAutoPopulateSeriesPaint(false);
        renderer.setDefaultStroke(new BasicStroke(1.5f));
        renderer.setAutoPopulateSeriesStroke(false);
        return renderer;
    }

    private static void put(DefaultCategoryDataset to, double value, String series, String name) {
        to.addValue(Double.isFinite(value) ? value : null, series, name);
    }

    private static double nonNaN(double value) {
        return Double.isNaN(value) ? 0 : value;
    }

    /** Labels with one digit after the decimal point. */
    private static final class ShareLabels extends StandardCategoryItemLabelGenerator implements CategoryItemLabelGenerator {
        private static final long serialVersionUID = 1;

        @Override
        public @Nullable String generateLabel(CategoryDataset shares, int series, int edit) {
            Number share = shares.getValue(series, edit);
            return share == null ? null : NumberText.percent(share.doubleValue());
        }
    }
}
