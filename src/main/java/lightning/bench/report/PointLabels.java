package lightning.bench.report;

import static java.util.Objects.requireNonNull;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import org.jfree.chart.annotations.AbstractXYAnnotation;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.PlotRenderingInfo;
import org.jfree.chart.plot.XYPlot;
import org.jspecify.annotations.Nullable;

/** Labels of chart points, moved so that they cover neither each other nor a point. */
final class PointLabels extends AbstractXYAnnotation {
    private static final long serialVersionUID = 1;
    private static final double GAP = 8;
    private static final double LINE = 13;
    private static final double POINT = 9;
    /** Maximum number of lines that a label moves. */
    private static final int MAX_LINES = 8;

    private record Label(double x, double y, String text, Color color) {}

    private final boolean isRightOfPoint;

    private final transient List<Label> labels = new ArrayList<>();

    /** @param isRightOfPoint whether labels are right of points, where lines end; otherwise above and below, clear of whiskers */
    PointLabels(boolean isRightOfPoint) {
        this.isRightOfPoint = isRightOfPoint;
    }

    /** Adds a label to the point at x, y, in axis units. */
    void add(double x, double y, String text, Color color) {
        labels.add(new Label(x, y, text, color));
    }

    @Override
    public void draw(Graphics2D g, XYPlot plot, Rectangle2D area, ValueAxis xAxis, ValueAxis yAxis, int index, PlotRenderingInfo info) {
        List<Point2D> points = new ArrayList<>();
        List<Rectangle2D> occupied = new ArrayList<>();
        for (Label label : labels) {
            Point2D p = new Point2D.Double(xAxis.valueToJava2D(label.x, area, plot.getDomainAxisEdge()),
                    yAxis.valueToJava2D(label.y, area, plot.getRangeAxisEdge()));
            points.add(p);
            occupied.add(new Rectangle2D.Double(p.getX() - POINT / 2, p.getY() - POINT / 2, POINT, POINT));
        }
        g.setFont(ChartSvg.FONT);
        for (int i = 0; i < labels.size(); i++) {
            draw(g, labels.get(i), points.get(i), area, occupied);
        }
    }

    private void draw(Graphics2D g, Label label, Point2D p, Rectangle2D area, List<Rectangle2D> occupied) {
        double width = ChartSvg.widthOf(label.text);
        Rectangle2D bounds = requireNonNull(findFreeBounds(p, width, area, occupied));
        occupied.add(bounds);
        double gapUp = p.getY() - bounds.getCenterY();
        if (Math.abs(gapUp) > 1.6 * LINE) {
            g.setPaint(PlotColor.MUTED.color());
            g.setStroke(PlotStyle.HAIRLINE);
            boolean right = bounds.getX() > p.getX();
            g.draw(new Line2D.Double(p.getX(), p.getY(), right ? bounds.getX() - 2 : bounds.getMaxX() + 2, bounds.getCenterY()));
        }
        g.setPaint(label.color);
        g.drawString(label.text, (float) bounds.getX(), (float) (bounds.getCenterY() + 4));
    }

    /** Returns the nearest free position, line by line. */
    private @Nullable Rectangle2D findFreeBounds(Point2D p, double width, Rectangle2D area, List<Rectangle2D> occupied) {
        Rectangle2D first = null;
        double right = p.getX() + (isRightOfPoint ? GAP : -4);
        double left = p.getX() - width + 4;
        for (int n = isRightOfPoint ? 0 : 1; n <= 2 * MAX_LINES; n++) {
            double y = p.getY() + (n % 2 == 0 ? 1 : -1) * ((n + 1) / 2) * LINE - LINE / 2;
            for (double x : isRightOfPoint ? new double[] {right} : new double[] {right, left}) {
                Rectangle2D bounds = new Rectangle2D.Double(x, y, width, LINE);
                first = first == null ? bounds : first;
                if (area.contains(bounds) && occupied.stream().noneMatch(bounds::intersects)) {
                    return bounds;
                }
            }
        }
        return first;
    }
}
