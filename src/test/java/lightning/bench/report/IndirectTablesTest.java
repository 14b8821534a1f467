package lightning.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import lightning.bench.result.BenchResults;
import lightning.bench.result.BenchRun;
import lightning.bench.result.IndirectAccuracy;
import lightning.bench.result.IndirectCost;
import lightning.bench.result.IndirectGrowth;
import lightning.bench.result.IndirectResults;
import lightning.bench.result.MachineSpec;
import lightning.bench.result.SystemLoad;
import lightning.bench.result.TimeSamples;
import lightning.render.measure.IndirectError;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class IndirectTablesTest {
    private static final BenchRun RUN = new BenchRun("2026-01-31T12:00:00Z", "abc", List.of(),
            new MachineSpec("Linux", "cpu", 2, 512, 1, 1, "Java 25"), new SystemLoad(0, 0, 0), 1, 2, 3, false, 1, 1, true, 1, List.of());

    private static TimeSamples ms(double v) {
        return new TimeSamples(v, v, v, List.of(v, v, v));
    }

    private static IndirectCost cost(String scene, double first, double colorMs) {
        return new IndirectCost(scene, 1920, 1080, 3, "2 bounces", ms(first), ms(500), ms(900), 40, 10, 100, List.of(
                new IndirectCost.Edit("color", "key: color", ms(colorMs), ms(10), true),
                new IndirectCost.Edit("position", "key: position", ms(150), ms(30), true)));
    }

    private static IndirectAccuracy.Point point(int spacing, int rays, int bounces, double ms, double error) {
        return new IndirectAccuracy.Point(spacing, rays, bounces, ms(ms), 10, 100, new IndirectError(error, error, error, 0.01, 0.2));
    }

    private static IndirectGrowth.Point growth(long pixels, double ms) {
        return new IndirectGrowth.Point(pixels, 10, 100, 40, ms(ms), ms(100), ms(5), ms(20));
    }

    private static BenchResults results() {
        var accuracy = new IndirectAccuracy("hall", 480, 270, 500, 1024, 16, ms(100), List.of(point(8, 64, 2, 300, 0.05),
                point(16, 64, 2, 200, 0.06), point(16, 256, 2, 400, 0.055), point(8, 64, 1, 250, 0.07), point(8, 64, 4, 330, 0.05)));
        var growth = new IndirectGrowth("pixels", "room", List.of(growth(1920L * 1080, 1000), growth(3840L * 2160, 3100)));
        return new BenchResults(RUN, List.of(), List.of(), List.of(), List.of(), List.of(), List.of(), new IndirectResults(
                List.of(accuracy), List.of(cost("window", 1900, 60), cost("hall", 5000, 80), cost("night", 3000, 80)), List.of(growth),
                List.of(), List.of(), List.of()), List.of());
    }

    private static String table(String name) {
        return new IndirectTables(results()).of("indirect " + name);
    }

    @Test
    void targets_compareMeasuredValuesWithLimits() {
        assertThat(table("targets")).contains("| first pass, added | window | 1500 ms | 1400 ms | yes |\n",
                "| first pass, added | hall | 4000 ms | 4500 ms | no |\n",
                "| color of a light, added | window | 60 ms | 50 ms | yes |\n", "| color of a light, added | hall | 60 ms | 70 ms | no |\n",
                "| moved light, added | night | 100 ms | 120 ms | no |\n",
                "| memory, added | hall | 45 bytes a pixel | 40 bytes a pixel | yes |\n",
                "| color of a light, relative to `window` | night | 1.50 times | 1.33 times | yes |\n",
                "| first pass at 3840×2160, relative to 1920×1080 | room | 3 times | 3.10 times | no |\n");
    }

    @Test
    void targetWithoutMeasurement_isOpen() {
        BenchResults none = new BenchResults(RUN, List.of(), List.of(), List.of(), List.of(), List.of(), List.of(), List.of());
        assertThat(new IndirectTables(none).of("indirect targets")).contains("| first pass, added | hall | 4000 ms | – | – |\n");
    }

    @Test
    void errors_markTheParetoFront() {
        assertThat(table("errors").lines().filter(line -> line.endsWith("| yes |"))).hasSize(2)
                .anyMatch(line -> line.startsWith("| hall | 8 | 64 |")).anyMatch(line -> line.startsWith("| hall | 16 | 64 |"));
    }

    @Test
    void edits_showWhatTheySaveOfAFirstPass() {
        assertThat(table("edits")).contains("| window | color | 60.0 | 10.0 | 50.0 | 96.8 % | 93.3 % | yes |");
    }

    @Test
    void growth_showsSlopes() {
        assertThat(table("growth"))
                .contains("| pixels | room | 2073600 | 8294400 | 10 to 10 | 100 to 100 | 900 to 3000 | 0.87 | 20.0 to 20.0 | 0.00 |");
    }

    @Test
    @Slow
    void charts_nameBuildAndLabelEachSetting(@TempDir Path folder) throws IOException {
        Map<String, String> charts = DocumentCharts.draw(results(), IndirectDocumentCharts.labels(results()), folder);
        assertThat(charts).containsOnlyKeys("indirect-error-hall.svg", IndirectDocumentCharts.BOUNCES, "indirect-growth-pixels.svg");
        assertThat(charts.values()).allMatch(svg -> svg.contains("build abc, 2026-01-31T12:00:00Z") && !svg.contains("var("));
        assertThat(charts.get("indirect-error-hall.svg")).contains(">8, 64<", ">16, 64<", ">16, 256<");
        assertThat(charts.get(IndirectDocumentCharts.BOUNCES)).contains(">hall<", "20 %");
        assertThat(charts.get("indirect-growth-pixels.svg")).contains(">first pass, added<", ">moved light<", ">intensity<");
    }
}
