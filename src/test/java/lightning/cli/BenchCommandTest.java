package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import lightning.bench.ResultsReporter;
import lightning.bench.report.HtmlReport;
import lightning.bench.result.BenchResults;
import lightning.bench.result.EditResult;
import lightning.bench.result.ResultsFile;
import lightning.bench.result.SceneResult;
import lightning.sample.DefaultLocale;
import lightning.sample.Slow;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

@Slow
class BenchCommandTest {
    @TempDir
    Path folder;
    private Path scene;
    private Path out;

    @BeforeEach
    void write() throws Exception {
        scene = CliResult.scene(folder);
        out = folder.resolve("new/results");
    }

    /** Runs a quick benchmark with few samples. */
    private CliResult bench(Object... more) {
        List<Object> words = new ArrayList<>(List.of("bench", "-o", out, "--quick", "--repetitions", 1, "--size", "24x16", "--threads", 2));
        words.addAll(Arrays.asList(more));
        return CliResult.run(words.toArray());
    }

    private BenchResults results() throws Exception {
        return ResultsFile.readJson(out.resolve("results.json"));
    }

    @Test
    void run_writesResultsTablesAndPictures() throws Exception {
        CliResult run = bench(scene, "--figure", 6, "--seed", 9).assertSuccess();
        assertThat(run.out()).contains("1 scene; this will take about", "a at 24 x 16, depth 2, 3 objects, 3 lights",
                "color ", "intensity ",
                "memory: ", "results.json");
        assertThat(results().scenes().getFirst().edits()).extracting(EditResult::edit).containsExactly("color", "intensity");
        assertThat(results().run().complete()).isTrue();
        assertThat(results().run().seed()).isEqualTo(9);
        assertThat(results().run().arguments()).contains("--figure", "6");
        assertThat(Files.readAllLines(out.resolve("results.csv"))).hasSize(1 + 2 + 2 * 7);
        assertThat(out.resolve("pictures/a-color-full.png")).exists();
        assertThat(out.resolve("report.html")).content().contains("a-color-full.png", "data:image/");
    }

    /** Covers the quick run and the locale in one slow test; Egypt's digits differ from ASCII digits. */
    @Test
    void quickRun_inArabicLocale_printsAsciiDigits() throws Exception {
        CliResult run = DefaultLocale.during(Locale.of("ar", "EG"), () -> bench(scene).assertSuccess());
        assertThat(results().scenes().getFirst().edits()).hasSize(15);
        assertThat(results().growth()).hasSize(4);
        assertThat(results().drift()).hasSize(1);
        String report = Files.readString(out.resolve("report.html"));
        assertThat(report).containsPattern("\"lights\":[0-9]+,");
        assertThat(List.of(run.out(), report, Files.readString(out.resolve("results.csv")), Files.readString(out.resolve("results.json"))))
                .allSatisfy(LocaleTest::assertAsciiDigits);
    }

    @Test
    void everySize_isMeasured() throws Exception {
        bench(scene, "--figure", 13, "--size", "30x20").assertSuccess();
        assertThat(results().scenes()).extracting(SceneResult::width).containsExactly(24, 30);
    }

    @Test
    void unreadableScene_skipsOnlyThatScene() throws Exception {
        Path bad = Files.writeString(folder.resolve("bad.jen"), "jen 1\nlight b laser {}\n");
        CliResult run = bench(bad, scene, folder.resolve("none.jen"), "--figure", 21);
        assertThat(run.exit()).isEqualTo(2);
        assertThat(run.err()).contains(bad + ":2:9: light 'b': type", "none.jen: file not found").doesNotContain("Exception");
        assertThat(results().scenes()).extracting(SceneResult::scene).containsExactly("a");
        assertThat(results().problems()).hasSize(2);
        assertThat(results().problems().getFirst().what()).contains("light 'b': type");
    }

    @Test
    void scenesWithSameName_areDistinguished() throws Exception {
        Path other = Files.createDirectory(folder.resolve("other"));
        bench(scene, CliResult.scene(other), "--figure", 21).assertSuccess();
        assertThat(results().scenes()).extracting(SceneResult::scene).containsExactly("a", "a-2");
    }

    @Test
    void figureWithoutScene_usesBird() throws Exception {
        bench("--figure", 21).assertSuccess();
        assertThat(results().scenes()).extracting(SceneResult::scene).containsExactly("bird");
    }

    @Test
    void baselineWithOtherErrors_exitsWith1() throws Exception {
        bench(scene, "--figure", 21).assertSuccess();
        Path old = out.resolve("results.json");
        // As if half resolution had had no error.
        Files.writeString(old, Files.readString(old).replaceFirst("\"values\" : \\d+", "\"values\" : 0"));
        Path stored = Files.copy(old, folder.resolve("old.json"));
        CliResult run = bench(scene, "--figure", 21, "--baseline", stored);
        assertThat(run.exit()).isEqualTo(1);
        assertThat(run.out()).contains("less accurate: a at 24x16, ambience, ambience 0.5 → 0.05, half resolution: differing values",
                "baseline: 7 measurements compared");
    }

    @Test
    void baselineWithOtherEdits_isRejected() throws Exception {
        bench(scene, "--figure", 21).assertSuccess();
        Path stored = Files.copy(out.resolve("results.json"), folder.resolve("old.json"));
        CliResult run = bench(scene, "--figure", 13, "--baseline", stored);
        assertThat(run.exit()).isEqualTo(2);
        assertThat(run.err()).contains("old.json: contains none of the edits measured now");
    }

    @Test
    void invalidArguments_areRejected() throws Exception {
        CliResult.run("bench", scene).assertRejected("--output");
        bench(scene, "--figure", 12).assertRejected(
                "--figure must be a figure with measured edits (6 to 11, 13 to 26, B1 to B4 or B for Appendix B), was '12'");
        bench(scene, "--repetitions", 0).assertRejected("repetitions");
        bench(scene, "--size", "0x5").assertRejected("width and height must be from 1");
        bench(scene, "--antialiased", "b").assertRejected("--antialiased must be the name of a measured scene (a), was 'b'");
        bench(scene, "--baseline", folder.resolve("no.json")).assertRejected("no.json: file not found");
        bench(scene, "--baseline", scene).assertRejected("expected a results file of 'lightning bench'");
        bench(folder.resolve("no.jen")).assertRejected("no.jen: file not found", "no scene to measure");
    }

    @Test
    void appendixBFigure_measuresItsScene() throws Exception {
        bench("--figure", "B1", "--size", "16x12").assertSuccess();
        assertThat(results().scenes()).extracting(SceneResult::scene).containsOnly("balls");
        assertThat(results().scenes().getLast().edits()).extracting(EditResult::figure).doesNotContain("").hasSize(15);
    }

    @Test
    void report_isRebuiltFromStoredResults() throws Exception {
        bench(scene, "--figure", 21).assertSuccess();
        Path page = out.resolve("report.html");
        String first = Files.readString(page);
        Files.delete(page);
        assertThat(CliResult.run("bench", "--report", out.resolve("results.json")).assertSuccess().out()).contains("report.html");
        assertThat(page).hasContent(first);

        Path elsewhere = folder.resolve("elsewhere");
        CliResult.run("bench", "--report", out.resolve("results.json"), "-o", elsewhere).assertSuccess();
        assertThat(elsewhere.resolve("report.html")).as("with the images next to the results").hasContent(first);
    }

    @Test
    void reportWithScene_isRejected() throws Exception {
        bench(scene, "--figure", 21).assertSuccess();
        CliResult.run("bench", scene, "--report", out.resolve("results.json")).assertRejected("--report", "measures no scene");
        CliResult.run("bench", "--report", folder.resolve("none.json")).assertRejected("none.json: file not found");
    }

    @Test
    void partialTables_areWrittenDuringTheRun_reportAtTheEnd() throws Exception {
        bench(scene, "--figure", 21).assertSuccess();
        Path stored = Files.createDirectory(folder.resolve("kept"));
        BenchOutput files = new BenchOutput(stored, HtmlReport::write);
        files.writePeriodically(results());
        assertThat(stored).isDirectoryNotContaining(file -> file.endsWith("report.html"));
        assertThat(ResultsFile.readJson(stored.resolve("results.json"))).isEqualTo(results());
        assertThat(stored.resolve("results.csv")).exists();
        files.write(results());
        assertThat(stored.resolve("report.html")).exists();
    }

    @Test
    void interruptedThread_stillWritesResults() throws Exception {
        bench(scene, "--figure", 21).assertSuccess();
        BenchResults results = results();
        Path stored = Files.createDirectory(folder.resolve("kept"));
        Thread.currentThread().interrupt();
        new BenchOutput(stored, ResultsReporter.NONE).writeUninterruptibly(results,
                () -> assertThat(stored.resolve("results.csv")).exists());
        assertThat(Thread.interrupted()).isTrue();
        assertThat(ResultsFile.readJson(stored.resolve("results.json"))).isEqualTo(results);
    }

    @Test
    void canceledRun_isReported() {
        Thread.currentThread().interrupt();
        CliResult run = bench(scene);
        assertThat(Thread.interrupted()).isTrue();
        assertThat(run.exit()).isEqualTo(130);
        assertThat(run.err()).endsWith("lightning: canceled\n");
    }
}
