package lightning.bench.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.function.DoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lightning.bench.result.BenchResults;
import lightning.bench.result.SampleResults;
import lightning.render.measure.AccuracySetting;
import lightning.render.measure.ParetoFront;
import lightning.sample.Slow;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Numbers and charts of the report's script, in a browser. */
@Slow
class ReportChartTest {
    private static final String BARS = """
            shareChart("a \\"label\\"", [{ name: "color & <b>", paper: 2, ours: 9.5, stale: 13, limit: 1 },
              { name: "add", paper: 29, ours: NaN, stale: 130, limit: 12 }])""";

    @TempDir
    private static Path folder;

    private static ReportPage page;

    @BeforeAll
    static void open() throws IOException {
        page = ReportPage.open(
                new BenchResults(SampleResults.RUN, List.of(), List.of(), List.of(), List.of(), List.of(), List.of(), List.of()), folder);
    }

    @AfterAll
    static void close() {
        if (page != null) {
            page.close();
        }
    }

    private static Object text(String expression) {
        return page.evaluate(expression);
    }

    private static String svg(String chart) {
        return (String) page.evaluate("new XMLSerializer().serializeToString(" + chart + ")");
    }

    @Test
    void numbers_haveThreeDigits() {
        assertThat(text("threeDigits(0.12345)")).isEqualTo("0.123");
        assertThat(text("threeDigits(12.345)")).isEqualTo("12.3");
        assertThat(text("threeDigits(-123.45)")).isEqualTo("−123");
        assertThat(text("threeDigits(12345)")).isEqualTo("12\u202f345");
        assertThat(text("grouped(-1234567)")).isEqualTo("−1\u202f234\u202f567");
    }

    @Test
    void ticks_areShort() {
        assertThat(text("tick(0.1)")).isEqualTo("0.1");
        assertThat(text("tick(5 * 0.01)")).isEqualTo("0.05");
        assertThat(text("tick(1e-7)")).isEqualTo("0.0000001");
        assertThat(text("tick(200)")).isEqualTo("200");
        assertThat(text("tick(50000)")).isEqualTo("50\u202f000");
    }

    @Test
    void tinyErrors_usePowersOfTen() {
        assertThat(text("error(3.14e-8)")).isEqualTo("3.1·10⁻⁸");
        assertThat(text("error(9.97e-8)")).isEqualTo("1.0·10⁻⁷");
        assertThat(text("error(0.25)")).isEqualTo("0.250");
        assertThat(text("error(0)")).isEqualTo("0");
        assertThat(text("power(-12)")).isEqualTo("10⁻¹²");
    }

    @Test
    void smallShare_isNotNone() {
        assertThat(text("share(0, 270000)")).isEqualTo("none");
        assertThat(text("share(1, 270000)")).isEqualTo("< 0.1\u00a0%");
        assertThat(text("share(1, 4)")).isEqualTo("25.0\u00a0%");
    }

    @Test
    void missingNumber_isDash() {
        for (String call : List.of("percent(NaN)", "ms(NaN)", "error(NaN)", "decibels(NaN)", "similarity(NaN)", "threeDigits(NaN)")) {
            assertThat(text(call)).as(call).isEqualTo("–");
        }
        assertThat(text("ms(Infinity)")).isEqualTo("∞");
        assertThat(text("percent(-Infinity)")).isEqualTo("−∞");
        assertThat(text("decibels(Infinity)")).isEqualTo("∞");
    }

    @Test
    void sizes_haveUnits() {
        assertThat(text("[bytes(117.6e6), bytes(2e9), bytes(1500), bytes(12), bytes(-3.2e6)]"))
                .isEqualTo(List.of("117.6\u00a0MB", "2.0\u00a0GB", "1.5\u00a0kB", "0.0\u00a0kB", "−3.2\u00a0MB"));
    }

    @Test
    void mediansAndMeans_areOfAllValues() {
        assertThat(text("[median([4, 1, 3]), median([4, 10, 1, 3]), mean([1, 2, 6])]")).isEqualTo(List.of(3L, 3.5, 3L));
        assertThat(text("[Number.isNaN(median([])), Number.isNaN(mean([]))]")).isEqualTo(List.of(true, true));
    }

    /** The tables of the documents, which Java writes, and the report show the same results. */
    @Test
    void numbers_readAsInDocuments() {
        Random random = new Random(1);
        double[] values = IntStream.range(0, 300).mapToDouble(_ -> random.nextGaussian() * Math.pow(10, random.nextInt(-4, 7))).toArray();
        Map<String, DoubleFunction<String>> texts = Map.of("threeDigits", NumberText::threeDigits, "percent", NumberText::percent);
        texts.forEach((name, java) -> assertThat(page.evaluate("arguments[0].map(" + name + ")", Arrays.stream(values).boxed().toList()))
                .as(name).isEqualTo(Arrays.stream(values).mapToObj(java).toList()));
    }

    private record Point(double median, double error) {}

    @Test
    void front_isThatOfTheProgram() {
        Random random = new Random(2);
        for (int i = 0; i < 20; i++) {
            List<Point> points = IntStream.range(0, random.nextInt(8))
                    .mapToObj(_ -> new Point(1 + random.nextInt(4), random.nextInt(4))).toList();
            var given = points.stream().map(p -> Map.of("median", p.median(), "error", p.error())).toList();
            String front = page.evaluate("paretoFront(arguments[0]).map(p => `${p.median} ${p.error}`).join()", given).toString();
            assertThat(front).isEqualTo(ParetoFront.of(points, Point::median, Point::error).stream()
                    .map(p -> Math.round(p.median()) + " " + Math.round(p.error())).collect(Collectors.joining(",")));
        }
    }

    private static String point(String label, double lower, double median, double upper, double error) {
        return String.format(Locale.ROOT, "{ label: \"%s\", ink: \"ours\", shape: SHAPES[0], isFilled: true, error: %s,"
                + " time: { lowerQuartile: %s, median: %s, upperQuartile: %s } }", label, error, lower, median, upper);
    }

    private static String pareto(String... points) {
        return svg("paretoChart(\"chart\", [" + String.join(",", points) + "], 400, 300, powerTick)");
    }

    @Test
    void everyPoint_isLabeled() {
        assertThat(pareto(point("ratio", 1, 2, 3, 1e-8), point("full trace", 8, 9, 10, 0))).contains(">ratio<", ">full trace<", ">0<",
                ">10⁻⁸<");
    }

    @Test
    void everyPoint_isInsideTheChart() {
        List<Double> places = numbers(page.evaluate(String.format(Locale.ROOT, """
                [...paretoChart("chart", [%s, %s, %s], 400, 300, powerTick).querySelectorAll("[transform]")]
                  .flatMap(p => p.getAttribute("transform").match(/[\\d.]+/g).map(Number))""",
                point("a", 1, 2, 3, 1e-8), point("b", 8, 9, 10, 0), point("c", 50, 60, 70, 5))));
        assertThat(places).hasSize(6);
        for (int i = 0; i < 6; i += 2) {
            assertThat(places.get(i)).isBetween(30.0, 390.0);
            assertThat(places.get(i + 1)).isBetween(10.0, 275.0);
        }
    }

    @Test
    void equalPoints_giveAChart() {
        assertThat(pareto(point("full trace", 5, 5, 5, 0))).contains(">full trace<").doesNotContain("NaN", "Infinity");
        assertThat(pareto()).contains(">no measurements<").doesNotContain("NaN", "Infinity");
    }

    @Test
    void unorderedQuartiles_areSkipped() {
        String wrong = point("exact", 3, 2, 1, 0);

        assertThat(pareto(wrong, point("full trace", 8, 9, 10, 0))).contains(">full trace<").doesNotContain(">exact<");
        assertThat(pareto(wrong)).contains(">no measurements<");
    }

    @Test
    void labels_coverNeitherEachOtherNorPoints() {
        String points = """
                [0, 1, 2, 3, 4].map(i => ({ label: `setting ${i}`, ink: "ours", shape: SHAPES[i], isFilled: true, error: 0.1,
                  time: { lowerQuartile: 10 + 0.1 * i, median: 10 + 0.1 * i, upperQuartile: 10 + 0.1 * i } }))""";
        List<?> places = (List<?>) page.evaluate(String.format(Locale.ROOT, """
                (() => {
                  const chart = paretoChart("chart", %s, 560, 330, powerTick);
                  document.body.append(chart);
                  const labels = [...chart.querySelectorAll("text")].filter(t => t.textContent.startsWith("setting"));
                  const found = labels.map(t => [t.getBBox().x, t.getBBox().x + t.getBBox().width, t.getBBox().y]);
                  chart.remove();
                  return found;
                })()""", points));
        assertThat(places).hasSize(5);
        for (int i = 0; i < 5; i++) {
            for (int j = 0; j < i; j++) {
                List<Double> a = numbers(places.get(i));
                List<Double> b = numbers(places.get(j));
                assertThat(a.get(1) <= b.get(0) || b.get(1) <= a.get(0) || Math.abs(a.get(2) - b.get(2)) >= 12).as("%s %s", a, b).isTrue();
            }
        }
    }

    private static List<Double> numbers(Object list) {
        return ((List<?>) list).stream().map(v -> ((Number) v).doubleValue()).toList();
    }

    @Test
    void everySetting_hasColorAndItsOwnShape() {
        assertThat((List<?>) page.evaluate("SHAPES")).doesNotHaveDuplicates().hasSameSizeAs(AccuracySetting.values());
        assertThat(page.evaluate("SETTING_INKS"))
                .isEqualTo(List.of("orange", "red", "muted", "muted", "purple", "sky", "green", "ours", "text"));
    }

    @Test
    void lines_haveTicksOfZeroAndNamesAtTheirEnds() {
        String chart =
                svg("""
                        curveChart("chart", [{ name: "exact", ink: "ours", points: [[0, 0], [10, 0.1]] }, { name: "", ink: "paper", points: [[1, 1]] },
                          { name: "none", ink: "red", points: [] }, { name: "odd", ink: "red", points: [[NaN, 1], [1, -1]] }], 300, tick, tick)""");
        assertThat(chart).contains(">exact<", ">0<", ">10<", "stroke=\"var(--paper)\"").doesNotContain("NaN", "Infinity", ">none<",
                ">odd<");
        assertThat(svg("curveChart(\"chart\", [], 300, tick, tick)")).contains(">no measurements<");
    }

    @Test
    void crowdedTicks_areWholeDecades() {
        String wide =
                "curveChart(\"chart\", [{ name: \"first pass, added\", ink: \"ours\", points: [[20000, 1], [8000000, 2]] }], 300, tick, () => \"\")";
        assertThat(svg(wide)).contains(">100\u202f000<", ">1\u202f000\u202f000<").doesNotContain(">200\u202f000<");
        assertThat(svg(wide.replace("000,", ",").replace("000000", "000"))).contains(">20<", ">100<", ">5\u202f000<");
    }

    @Test
    void colors_followTheme() {
        assertThat(svg(BARS)).contains("var(--ours)", "var(--paper)", "var(--sky)").doesNotContain("rgb(", "#");
    }

    @Test
    void text_hasLaidOutWidth() {
        assertThat(svg(BARS)).containsPattern("<text [^>]*textLength=\"\\d+(\\.\\d+)?\"[^>]*>color &amp; &lt;b&gt;</text>");
    }

    @Test
    void bars_areLabeledWithShares() {
        assertThat(svg(BARS)).contains(">2.0\u00a0%<", ">9.5\u00a0%<", ">130.0\u00a0%<").doesNotContain(">–<", "NaN");
    }

    @Test
    void barsOfLosses_endInsideChart() {
        List<Double> widths = numbers(page.evaluate("""
                [...shareChart("chart", [{ name: "gain", ours: 20 }, { name: "loss", ours: 1000 }]).querySelectorAll("rect")]
                  .map(bar => Number(bar.getAttribute("width")))"""));
        assertThat(widths).hasSize(2);
        assertThat(widths.get(1) / widths.get(0)).isCloseTo(1000 / 20.0, withinPercentage(2));
        assertThat(widths.get(1)).isLessThan(560);
    }

    @Test
    void shareBeyondAllMeasurements_isLeftOut() {
        assertThat(svg("shareChart(\"chart\", [{ name: \"odd\", ours: Number.MAX_VALUE, stale: 50, limit: -Number.MAX_VALUE }])"))
                .contains(">50.0\u00a0%<").doesNotContain("Infinity", "e+");
    }

    @Test
    void chart_hasAccessibleLabel() {
        assertThat(svg(BARS)).contains("role=\"img\" aria-label=\"a &quot;label&quot;\"");
    }

    @Test
    void chart_hasNoIds() {
        assertThat(svg(BARS)).doesNotContain("id=", "url(");
    }
}
