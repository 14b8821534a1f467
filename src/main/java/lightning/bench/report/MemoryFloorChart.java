package lightning.bench.report;

import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.jfree.chart.labels.ItemLabelAnchor;
import org.jfree.chart.labels.ItemLabelPosition;
import org.jfree.chart.labels.StandardCategoryItemLabelGenerator;
import org.jfree.chart.plot.CategoryPlot;
import org.jfree.chart.renderer.category.LineAndShapeRenderer;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.chart.ui.TextAnchor;
import org.jfree.data.category.CategoryDataset;
import org.jfree.data.category.DefaultCategoryDataset;

/** Chart of each edit's time against its memory floor, the time that memory needs to move its bytes. */
final class MemoryFloorChart {
    private static final int WIDTH = 550;
    private static final int ROW = 19;
    private static final int AXIS = 26;

    /** Edit with the milliseconds of its floor, > 0, and its median. */
    record Row(String name, double floor, double time) {}

    private MemoryFloorChart() {}

    static String svg(String label, List<Row> rows) {
        DefaultCategoryDataset data = new DefaultCategoryDataset();
        double low = Double.POSITIVE_INFINITY;
        double high = 0;
        for (Row row : rows) {
            data.addValue(row.floor, "floor", row.name);
            data.addValue(row.time, "time", row.name);
            low = Math.min(low, Math.min(row.floor, row.time));
            high = Math.max(high, Math.max(row.floor, row.time));
        }
        CategoryPlot plot = PlotStyle.rows(rows.isEmpty() ? new DecadeAxis(1, 10, NumberText::tick)
                : new DecadeAxis(low / 1.5, high * 2.4, NumberText::tick));
        plot.setDomainGridlinesVisible(true);
        plot.setDomainGridlinePaint(PlotColor.GRID.color());
        plot.setDomainGridlineStroke(PlotStyle.HAIRLINE);
        LineAndShapeRenderer dots = new LineAndShapeRenderer(false, true);
        dots.setSeriesPaint(0, PlotColor.TEXT.color());
        dots.setSeriesShape(0, new Rectangle2D.Double(-1, -6, 2, 12));
        dots.setSeriesPaint(1, PlotColor.OURS.color());
        dots.setSeriesShape(1, new Ellipse2D.Double(-4, -4, 8, 8));
        dots.setSeriesItemLabelGenerator(1, new FloorRatioLabels());
        dots.setSeriesItemLabelsVisible(1, true);
        dots.setSeriesItemLabelFont(1, ChartSvg.FONT);
        dots.setSeriesItemLabelPaint(1, PlotColor.TEXT.color());
        dots.setSeriesPositiveItemLabelPosition(1, new ItemLabelPosition(ItemLabelAnchor.OUTSIDE3, TextAnchor.CENTER_LEFT));
        dots.setItemLabelInsets(new RectangleInsets(6, 6, 6, 6));
        plot.setDataset(data);
        plot.setRenderer(dots);
        return ChartSvg.of(PlotStyle.chart(plot), WIDTH, AXIS + ROW * rows.size(), label);
    }

    /** Labels with the ratio of time to floor. */
    private static final class FloorRatioLabels extends StandardCategoryItemLabelGenerator {
        private static final long serialVersionUID = 1;

        @Override
        public String generateLabel(CategoryDataset data, int series, int edit) {
            return "×\u202f" + NumberText.threeDigits(data.getValue(1, edit).doubleValue() / data.getValue(0, edit).doubleValue());
        }
    }
}
