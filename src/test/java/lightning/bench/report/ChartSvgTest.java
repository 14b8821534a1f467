package lightning.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.util.List;
import lightning.bench.report.ShareChart.Bar;
import org.junit.jupiter.api.Test;

class ChartSvgTest {
    private final String svg =
            ShareChart.svg("a \"label\"", List.of(new Bar("color & <b>", 2, 9.5, 13, 1), new Bar("add", 29, Double.NaN, 130, 12)));

    @Test
    void colors_followTheme() {
        assertThat(svg).contains("var(--ours)", "var(--paper)", "var(--sky)").doesNotContain("rgb(");
    }

    @Test
    void text_hasLaidOutWidth() {
        assertThat(svg).containsPattern("<text [^>]*textLength=\"\\d+\\.\\d\"[^>]*>color &amp; &lt;b&gt;</text>");
    }

    @Test
    void bars_areLabeledWithShares() {
        assertThat(svg).contains(">2.0\u00a0%<", ">9.5\u00a0%<", ">130.0\u00a0%<");
    }

    @Test
    void chart_hasAccessibleLabel() {
        assertThat(svg).contains("role=\"img\" aria-label=\"a &quot;label&quot;\"");
    }

    @Test
    void graphics_writeShapesAndTextsWhereTheyAre() {
        var graphics = new SvgGraphics();
        graphics.setColor(PlotColor.RED.color());
        graphics.translate(10, 20);
        graphics.fillRect(1, 2, 3, 4);
        Graphics2D inner = (Graphics2D) graphics.create();
        inner.setColor(new Color(1, 2, 3));
        inner.setStroke(new BasicStroke(2.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND, 1, new float[] {3, 1.5f}, 0));
        inner.drawLine(0, 0, 5, -7);
        inner.rotate(Math.PI / 2);
        inner.fill(new Ellipse2D.Double(0, 0, 2, 2));
        inner.setFont(ChartSvg.FONT);
        inner.drawString("a < b", 1, 2);
        graphics.drawPolygon(new int[] {0, 4, 4}, new int[] {0, 0, 4}, 3);
        assertThat(graphics.elements().lines()).hasSize(5).satisfiesExactly(
                line -> assertThat(line).isEqualTo("<rect x=\"11\" y=\"22\" width=\"3\" height=\"4\" style=\"fill:var(--red);\"/>"),
                line -> assertThat(line).isEqualTo("<line x1=\"10\" x2=\"15\" y1=\"20\" y2=\"13\" style=\"fill:none;stroke:rgb(1,2,3);"
                        + "stroke-width:2.5;stroke-linecap:round;stroke-linejoin:round;stroke-dasharray:3,1.5;\"/>"),
                line -> assertThat(line).startsWith("<path d=\"M9,22 C").endsWith("Z\" style=\"fill:rgb(1,2,3);\"/>"),
                line -> assertThat(line).contains("x=\"1\" y=\"2\" transform=\"matrix(0,1,-1,0,10,20)\"", ">a &lt; b</text>"),
                line -> assertThat(line)
                        .isEqualTo("<path d=\"M10,20 L14,20 L14,24 Z\" style=\"fill:none;stroke:var(--red);\"/>"));
    }

    @Test
    void shapesWithoutAnEnd_areLeftOut() {
        var graphics = new SvgGraphics();
        graphics.draw(new Line2D.Double(0, 0, Double.POSITIVE_INFINITY, 1));
        graphics.fill(new Ellipse2D.Double(0, Double.NaN, 1, 1));
        graphics.drawString("far", 0, Float.NEGATIVE_INFINITY);
        assertThat(graphics.elements()).isEmpty();
    }

    @Test
    void chart_hasNoIds() {
        assertThat(svg).doesNotContain("id=", "url(#");
    }
}
