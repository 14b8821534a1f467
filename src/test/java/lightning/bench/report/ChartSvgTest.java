package lightning.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

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
    void chart_hasNoIds() {
        assertThat(svg).doesNotContain("id=", "url(#");
    }
}
