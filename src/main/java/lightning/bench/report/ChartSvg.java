package lightning.bench.report;

import de.erichseifert.vectorgraphics2d.VectorGraphics2D;
import de.erichseifert.vectorgraphics2d.svg.SVGProcessor;
import de.erichseifert.vectorgraphics2d.util.PageSize;
import java.awt.Font;
import java.awt.font.FontRenderContext;
import java.awt.geom.Rectangle2D;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.jfree.chart.JFreeChart;

/**
 * Chart as inline SVG: colors become variables of the style sheet. Every text has the width that the layout assumed, for any font of the
 * reader.
 */
final class ChartSvg {
    static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 11);

    private static final Pattern SVG_HEADER = Pattern.compile("(?s)^.*?<svg[^>]*>");
    private static final Pattern CLIPS = Pattern.compile("(?s)<defs>.*?</defs>|<defs/>|\\sclip-path=\"[^\"]*\"");
    private static final Pattern COLOR = Pattern.compile("rgb\\((\\d+),(\\d+),(\\d+)\\)");
    private static final Pattern TEXT = Pattern.compile("<text ([^>]*)>([^<]*)</text>");
    private static final Pattern LONG_NUMBER = Pattern.compile("(\\d+\\.\\d\\d)\\d+");
    private static final Pattern REDUNDANT_STYLE = Pattern.compile("stroke:none;|stroke-miterlimit:10;|stroke-linecap:square;|(?<=\\n) +");
    private static final FontRenderContext METRICS = new FontRenderContext(null, true, true);

    /** Tests if Java can lay out text; Linux needs fontconfig and a font. */
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
        VectorGraphics2D graphics = new VectorGraphics2D();
        chart.draw(graphics, new Rectangle2D.Double(0, 0, width, height));
        var out = new ByteArrayOutputStream();
        try {
            new SVGProcessor().getDocument(graphics.getCommands(), new PageSize(width, height)).writeTo(out);
        } catch (IOException e) {
            throw new UncheckedIOException("writing to memory failed", e);
        }
        String svg = SVG_HEADER.matcher(out.toString(StandardCharsets.UTF_8)).replaceFirst("");
        svg = CLIPS.matcher(svg).replaceAll("");
        svg = COLOR.matcher(svg).replaceAll(ChartSvg::variable);
        svg = TEXT.matcher(svg).replaceAll(m -> Matcher.quoteReplacement(fitText(m)));
        svg = LONG_NUMBER.matcher(REDUNDANT_STYLE.matcher(svg).replaceAll("")).replaceAll("$1");
        return String.format(Locale.ROOT,
                "<svg class=\"chart\" viewBox=\"0 0 %d %d\" style=\"max-width:%dpx\" role=\"img\" aria-label=\"%s\">%s",
                width, height, width, HtmlWriter.escape(label), svg);
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

    private static String variable(MatchResult color) {
        return PlotColor.variable(Integer.parseInt(color.group(1)), Integer.parseInt(color.group(2)), Integer.parseInt(color.group(3)));
    }

    private static String fitText(MatchResult text) {
        String plainText = text.group(2).replace("&amp;", "&").replace("&lt;", "<").replace("&gt;", ">");
        return String.format(Locale.ROOT, "<text %s textLength=\"%.1f\" lengthAdjust=\"spacingAndGlyphs\">%s</text>",
                text.group(1), widthOf(plainText), text.group(2));
    }
}
