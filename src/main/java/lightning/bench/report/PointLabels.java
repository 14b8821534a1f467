package lightning.bench.report;

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

/** Names beside the points of a chart, moved until they cover neither each other nor a point. */
final class PointLabels extends AbstractXYAnnotation {
    private static final long serialVersionUID = 1;
    private static final double GAP = 8;
    private static final double LINE = 13;
    private static final double POINT = 9;
    /** How many lines a name may move away. */
    private static final int FAR = 8;

    private record Label(double x, double y, String text, Color color) {}

    private final boolean beside;

    private final transient List<Label> labels = new ArrayList<>();

    /** @param beside whether names stand right of points, where lines end; else above and below, free of whiskers */
    PointLabels(boolean beside) {
        this.beside = beside;
    }

    /** Names the point at x, y, in the units of the axes. */
    void add(double x, double y, String text, Color color) {
        labels.add(new Label(x, y, text, color));
    }

    @Override
    public void draw(Graphics2D g, XYPlot plot, Rectangle2D area, ValueAxis across, ValueAxis up, int index, PlotRenderingInfo info) {
        List<Point2D> points = new ArrayList<>();
        List<Rectangle2D> taken = new ArrayList<>();
        for (Label label : labels) {
            Point2D p = new Point2D.Double(across.valueToJava2D(label.x, area, plot.getDomainAxisEdge()),
                    up.valueToJava2D(label.y, area, plot.getRangeAxisEdge()));
            points.add(p);
            taken.add(new Rectangle2D.Double(p.getX() - POINT / 2, p.getY() - POINT / 2, POINT, POINT));
        }
        g.setFont(ChartSvg.FONT);
        for (int i = 0; i < labels.size(); i++) {
            draw(g, labels.get(i), points.get(i), area, taken);
        }
    }

    private void draw(Graphics2D g, Label label, Point2D p, Rectangle2D area, List<Rectangle2D> taken) {
        double width = ChartSvg.widthOf(label.text);
        Rectangle2D place = place(p, width, area, taken);
        taken.add(place);
        double gapUp = p.getY() - place.getCenterY();
        if (Math.abs(gapUp) > 1.6 * LINE) {
            g.setPaint(Ink.MUTED.color());
            g.setStroke(PlotLook.HAIRLINE);
            boolean right = place.getX() > p.getX();
            g.draw(new Line2D.Double(p.getX(), p.getY(), right ? place.getX() - 2 : place.getMaxX() + 2, place.getCenterY()));
        }
        g.setPaint(label.color);
        g.drawString(label.text, (float) place.getX(), (float) (place.getCenterY() + 4));
    }

    /** The nearest free place, line by line. */
    private Rectangle2D place(Point2D p, double width, Rectangle2D area, List<Rectangle2D> taken) {
        Rectangle2D first = null;
        double right = p.getX() + (beside ? GAP : -4);
        double left = p.getX() - width + 4;
        for (int n = beside ? 0 : 1; n <= 2 * FAR; n++) {
            double y = p.getY() + (n % 2 == 0 ? 1 : -1) * ((n + 1) / 2) * LINE - LINE / 2;
            for (double x : beside ? new double[] {right} : new double[] {right, left}) {
                Rectangle2D place = new Rectangle2D.Double(x, y, width, LINE);
                first = first == null ? place : first;
                if (area.contains(place) && taken.stream().noneMatch(place::intersects)) {
                    return place;
                }
            }
        }
        return first;
    }
}
