package lightning.bench.report;

import java.awt.Font;
import java.awt.font.FontRenderContext;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;
import org.jfree.chart.JFreeChart;

/**
 * Chart as inline SVG: colors become variables of the style sheet. Every text has the width that the layout assumed, for any font of the
 * reader.
 */
final class ChartSvg {
    static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 11);

    private static final FontRenderContext METRICS = new FontRenderContext(null, true, true);

    /** Returns whether Java can lay out text; Linux needs fontconfig and a font. */
    private static final boolean HAS_FONTS = hasFonts();

    private ChartSvg() {}

    /**
     * Draws a chart; without fonts, writes a note instead.
     *
     * @param width in units in which text is 11 high
     * @param label accessible label
     */
    static String of(JFreeChart chart, int width, int height, String label) {
        if (!HAS_FONTS) {
            return new HtmlWriter()
                    .element("p", "No chart (" + label + "): Java finds no font on this computer. Install fontconfig and a font "
                            + "(on Debian: fontconfig fonts-dejavu-core).", "class", "note")
                    .finish();
        }
        var graphics = new SvgGraphics();
        chart.draw(graphics, new Rectangle2D.Double(0, 0, width, height));
        return String.format(Locale.ROOT,
                "<svg class=\"chart\" viewBox=\"0 0 %d %d\" style=\"max-width:%dpx\" role=\"img\" aria-label=\"%s\">\n%s</svg>",
                width, height, width, HtmlWriter.escape(label), graphics.elements());
    }

    /**
     * Returns a chart as a standalone file.
     *
     * @param svg  result of {@link #of}
     * @param text description in the file
     */
    static String file(String svg, String text) {
        String inks = Arrays.stream(PlotColor.values()).map(ink -> "--" + ink.name().toLowerCase(Locale.ROOT) + ":"
                + String.format(Locale.ROOT, "#%06x", ink.color().getRGB() & 0xFFFFFF)).collect(Collectors.joining(";"));
        int end = svg.indexOf('>') + 1;
        return svg.substring(0, end).replace("<svg ", "<svg xmlns=\"http://www.w3.org/2000/svg\" ") + "<desc>" + HtmlWriter.escape(text)
                + "</desc><style>svg{" + inks + "}text{font-family:sans-serif}</style><rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>"
                + svg.substring(end) + "\n";
    }

    static double widthOf(String text) {
        return HAS_FONTS ? FONT.getStringBounds(text, METRICS).getWidth() : 0;
    }

    private static boolean hasFonts() {
        try {
            FONT.getLineMetrics("x", METRICS);
            return true;
        } catch (RuntimeException | InternalError | LinkageError e) {
            return false;
        }
    }
}
