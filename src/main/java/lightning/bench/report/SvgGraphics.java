package lightning.bench.report;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.PathIterator;
import java.awt.geom.Rectangle2D;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Graphics that write SVG elements, one per line: what a chart draws, without clips and transparency. Paints are opaque colors, named by
 * {@link PlotColor}.
 */
final class SvgGraphics extends ShapeGraphics {
    private static final String PATH_COMMANDS = "MLQCZ";
    private static final int[] POINTS = {1, 1, 2, 3, 0};

    private final StringBuilder elements;

    SvgGraphics() {
        elements = new StringBuilder();
    }

    private SvgGraphics(Graphics2D state, StringBuilder elements) {
        super(state);
        this.elements = elements;
    }

    /** Returns graphics with a copy of the state, which write to the same document. */
    @Override
    public Graphics create() {
        return new SvgGraphics(copyState(), elements);
    }

    /** Returns all elements. */
    String elements() {
        return elements.toString();
    }

    @Override
    public void draw(Shape shape) {
        if (getStroke() instanceof BasicStroke stroke) {
            add(shape, "fill:none;stroke:" + color() + ";" + style(stroke));
        } else {
            fill(getStroke().createStrokedShape(shape));
        }
    }

    @Override
    public void fill(Shape shape) {
        add(shape, "fill:" + color() + ";");
    }

    @Override
    public void drawString(String text, float x, float y) {
        AffineTransform transform = getTransform();
        if (!Float.isFinite(x) || !Float.isFinite(y)) {
            return;
        }
        boolean isMoved = (transform.getType() & ~AffineTransform.TYPE_TRANSLATION) == 0;
        String place = isMoved
                ? "x=\"" + number(x + transform.getTranslateX()) + "\" y=\"" + number(y + transform.getTranslateY()) + "\""
                : "x=\"" + number(x) + "\" y=\"" + number(y) + "\" transform=\"matrix(" + matrix(transform) + ")\"";
        elements.append(String.format(Locale.ROOT,
                "<text style=\"fill:%s;font-size:%spx;\" %s textLength=\"%.1f\" lengthAdjust=\"spacingAndGlyphs\">%s</text>%n", color(),
                number(getFont().getSize2D()), place, ChartSvg.widthOf(text), HtmlWriter.escape(text)).replace("\r", ""));
    }

    /** Adds a shape, unless a coordinate is infinite or not a number. */
    private void add(Shape shape, String style) {
        AffineTransform transform = getTransform();
        if (!isFinite(transform.createTransformedShape(shape))) {
            return;
        }
        boolean isMoved = (transform.getType() & ~AffineTransform.TYPE_TRANSLATION) == 0;
        double dx = transform.getTranslateX();
        double dy = transform.getTranslateY();
        String geometry = switch (shape) {
            case Line2D line when isMoved -> "<line x1=\"" + number(line.getX1() + dx) + "\" x2=\"" + number(line.getX2() + dx) + "\" y1=\""
                    + number(line.getY1() + dy) + "\" y2=\"" + number(line.getY2() + dy) + "\"";
            case Rectangle2D box when isMoved -> "<rect x=\"" + number(box.getX() + dx) + "\" y=\"" + number(box.getY() + dy)
                    + "\" width=\"" + number(box.getWidth()) + "\" height=\"" + number(box.getHeight()) + "\"";
            default -> "<path d=\"" + path(shape.getPathIterator(transform)) + "\"";
        };
        elements.append(geometry).append(" style=\"").append(style).append("\"/>\n");
    }

    private static boolean isFinite(Shape shape) {
        double[] points = new double[6];
        for (PathIterator outline = shape.getPathIterator(null); !outline.isDone(); outline.next()) {
            int count = 2 * POINTS[outline.currentSegment(points)];
            if (!Arrays.stream(points, 0, count).allMatch(Double::isFinite)) {
                return false;
            }
        }
        return true;
    }

    private static String path(PathIterator outline) {
        var text = new StringBuilder();
        double[] points = new double[6];
        for (; !outline.isDone(); outline.next()) {
            int kind = outline.currentSegment(points);
            text.append(PATH_COMMANDS.charAt(kind)).append(IntStream.range(0, POINTS[kind])
                    .mapToObj(i -> number(points[2 * i]) + "," + number(points[2 * i + 1])).collect(Collectors.joining(" "))).append(' ');
        }
        return text.toString().strip();
    }

    private static String style(BasicStroke stroke) {
        String cap = switch (stroke.getEndCap()) {
            case BasicStroke.CAP_ROUND -> "stroke-linecap:round;";
            // Dashes and short marks would be longer with the square ends that charts ask for by default.
            default -> "";
        };
        float[] dashes = stroke.getDashArray();
        return (stroke.getLineWidth() == 1 ? "" : "stroke-width:" + number(stroke.getLineWidth()) + ";") + cap
                + (stroke.getLineJoin() == BasicStroke.JOIN_ROUND ? "stroke-linejoin:round;" : "")
                + (dashes == null ? "" : "stroke-dasharray:" + IntStream.range(0, dashes.length).mapToObj(i -> number(dashes[i]))
                        .collect(Collectors.joining(",")) + ";");
    }

    private String color() {
        Color color = getColor();
        return PlotColor.variable(color.getRed(), color.getGreen(), color.getBlue());
    }

    private static String matrix(AffineTransform transform) {
        double[] values = new double[6];
        transform.getMatrix(values);
        return Arrays.stream(values).mapToObj(SvgGraphics::number).collect(Collectors.joining(","));
    }

    /** Returns a number with two decimals, without trailing zeros. */
    private static String number(double v) {
        return BigDecimal.valueOf(v).setScale(2, RoundingMode.HALF_UP).stripTrailingZeros().toPlainString();
    }
}
