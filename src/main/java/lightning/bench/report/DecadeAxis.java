package lightning.bench.report;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleFunction;
import org.jfree.chart.axis.AxisState;
import org.jfree.chart.axis.LogAxis;
import org.jfree.chart.axis.NumberTick;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.TextAnchor;

/** Logarithmic axis with few ticks at round numbers: whole decades, or 1, 2 and 5 of each if there are few decades. */
final class DecadeAxis extends LogAxis {
    private static final long serialVersionUID = 1;
    private static final int MAX_TICKS = 7;
    private static final double[] DIGITS = {1, 2, 5};

    private final transient DoubleFunction<String> label;
    private final double low;
    private final double high;

    /**
     * @param low   lower end, > 0
     * @param high  upper end, > {@code low}
     * @param label formats a tick
     */
    DecadeAxis(double low, double high, DoubleFunction<String> label) {
        this.label = label;
        this.low = low;
        this.high = high;
        setRange(low, high);
    }

    @Override
    public List<NumberTick> refreshTicks(Graphics2D g, AxisState state, Rectangle2D area, RectangleEdge edge) {
        boolean isHorizontal = RectangleEdge.isTopOrBottom(edge);
        TextAnchor anchor = isHorizontal ? edge == RectangleEdge.TOP ? TextAnchor.BOTTOM_CENTER : TextAnchor.TOP_CENTER
                : TextAnchor.CENTER_RIGHT;
        List<NumberTick> ticks = new ArrayList<>();
        for (double at : ticks()) {
            ticks.add(new NumberTick(at, label.apply(at), anchor, TextAnchor.CENTER, 0));
        }
        return ticks;
    }

    private List<Double> ticks() {
        int first = (int) Math.floor(Math.log10(low));
        int last = (int) Math.ceil(Math.log10(high));
        int step = Math.max(1, (last - first + MAX_TICKS - 1) / MAX_TICKS);
        List<Double> ticks = new ArrayList<>();
        for (int exponent = first; exponent <= last; exponent += step) {
            for (double digit : last - first <= 3 ? DIGITS : new double[] {1}) {
                double at = digit * Math.pow(10, exponent);
                if (at >= low * (1 - 1e-9) && at <= high * (1 + 1e-9)) {
                    ticks.add(at);
                }
            }
        }
        return ticks;
    }
}
