package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import lightning.bench.EditResult;
import lightning.bench.Reporter;
import lightning.bench.Results;
import lightning.bench.ResultsFile;
import lightning.bench.SceneResult;
import lightning.bench.report.Report;
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
        scene = Cli.scene(folder);
        out = folder.resolve("new/results");
    }

    /** A quick run of few samples. */
    private Cli bench(Object... more) {
        List<Object> words = new ArrayList<>(List.of("bench", "-o", out, "--quick", "--repetitions", 1, "--size", "24x16", "--threads", 2));
        words.addAll(Arrays.asList(more));
        return Cli.run(words.toArray());
    }

    private Results results() throws Exception {
        return ResultsFile.readJson(out.resolve("results.json"));
    }

    @Test
    void run_leavesResultsTablesAndPictures() throws Exception {
        Cli run = bench(scene, "--figure", 6, "--seed", 9).isDone();
        assertThat(run.out()).contains("1 scene; this will take about", "a at 24 x 16, depth 2, 3 shapes, 3 lights", "color ", "intensity ",
                "memory: ", "results.json");
        assertThat(results().scenes().getFirst().edits()).extracting(EditResult::edit).containsExactly("color", "intensity");
        assertThat(results().run().complete()).isTrue();
        assertThat(results().run().seed()).isEqualTo(9);
        assertThat(results().run().arguments()).contains("--figure", "6");
        assertThat(Files.readAllLines(out.resolve("results.csv"))).hasSize(1 + 2 + 2 * 7);
        assertThat(out.resolve("pictures/a-color-full.png")).exists();
        assertThat(out.resolve("report.html")).content().contains("<svg", "data:image/");
    }

    /** It takes long, so it is once for both: Egypt's digits are the ones that can be told from plain ones. */
    @Test
    void wholeQuickRun_hasCurvesAndPrintedEditsInPlainDigitsInEgyptToo() throws Exception {
        Cli run = DefaultLocale.during(Locale.of("ar", "EG"), () -> bench(scene).isDone());
        assertThat(results().scenes().getFirst().edits()).hasSize(15);
        assertThat(results().growth()).hasSize(4);
        assertThat(results().drift()).hasSize(1);
        String report = Files.readString(out.resolve("report.html"));
        assertThat(report).containsPattern("<svg class=\"chart\" viewBox=\"0 0 [0-9]+ [0-9]+\" style=\"max-width:[0-9]+px\"");
        assertThat(List.of(run.out(), report, Files.readString(out.resolve("results.csv")), Files.readString(out.resolve("results.json"))))
                .allSatisfy(LocaleTest::assertPlainDigits);
    }

    @Test
    void sizes_areEachMeasured() throws Exception {
        bench(scene, "--figure", 13, "--size", "30x20").isDone();
        assertThat(results().scenes()).extracting(SceneResult::width).containsExactly(24, 30);
    }

    @Test
    void unreadableScene_costsThatSceneOnly() throws Exception {
        Path bad = Files.writeString(folder.resolve("bad.jen"), "jen 1\nlight b laser {}\n");
        Cli run = bench(bad, scene, folder.resolve("none.jen"), "--figure", 21);
        assertThat(run.exit()).isEqualTo(2);
        assertThat(run.err()).contains(bad + ":2:9: light 'b': type", "none.jen: there is no such file").doesNotContain("Exception");
        assertThat(results().scenes()).extracting(SceneResult::scene).containsExactly("a");
        assertThat(results().problems()).hasSize(2);
        assertThat(results().problems().getFirst().what()).contains("light 'b': type");
    }

    @Test
    void scenesOfOneName_areTold() throws Exception {
        Path other = Files.createDirectory(folder.resolve("other"));
        bench(scene, Cli.scene(other), "--figure", 21).isDone();
        assertThat(results().scenes()).extracting(SceneResult::scene).containsExactly("a", "a-2");
    }

    @Test
    void figureWithoutAScene_isBirds() throws Exception {
        bench("--figure", 21).isDone();
        assertThat(results().scenes()).extracting(SceneResult::scene).containsExactly("bird");
    }

    @Test
    void baselineOfOtherErrors_endsWith1() throws Exception {
        bench(scene, "--figure", 21).isDone();
        Path old = out.resolve("results.json");
        // As if half resolution had shown every value right.
        Files.writeString(old, Files.readString(old).replaceFirst("\"values\" : \\d+", "\"values\" : 0"));
        Path kept = Files.copy(old, folder.resolve("old.json"));
        Cli run = bench(scene, "--figure", 21, "--baseline", kept);
        assertThat(run.exit()).isEqualTo(1);
        assertThat(run.out()).contains("less accurate: a at 24x16, ambience, ambience 0.5 → 0.05, half resolution: values that differ",
                "baseline: 7 measurements compared");
    }

    @Test
    void baselineOfOtherEdits_isRefused() throws Exception {
        bench(scene, "--figure", 21).isDone();
        Path kept = Files.copy(out.resolve("results.json"), folder.resolve("old.json"));
        Cli run = bench(scene, "--figure", 13, "--baseline", kept);
        assertThat(run.exit()).isEqualTo(2);
        assertThat(run.err()).contains("old.json: holds none of the edits that were measured now");
    }

    @Test
    void badArguments_areRefused() throws Exception {
        Cli.run("bench", scene).isRefusedSaying("--output");
        bench(scene, "--figure", 12).isRefusedSaying(
                "--figure must be one that shows measured edits (6 to 11, 13 to 26, B1 to B4 or B for Appendix B), was '12'");
        bench(scene, "--repetitions", 0).isRefusedSaying("repetitions");
        bench(scene, "--size", "0x5").isRefusedSaying("width and height must be from 1");
        bench(scene, "--baseline", folder.resolve("no.json")).isRefusedSaying("no.json: there is no such file");
        bench(scene, "--baseline", scene).isRefusedSaying("no results of 'lightning bench'");
        bench(folder.resolve("no.jen")).isRefusedSaying("no.jen: there is no such file", "there is no scene to measure");
    }

    @Test
    void exampleOfAppendixB_isMeasuredOnItsSceneByEveryPrintedEdit() throws Exception {
        bench("--figure", "B1", "--size", "16x12").isDone();
        assertThat(results().scenes()).extracting(SceneResult::scene).containsOnly("balls");
        assertThat(results().scenes().getLast().edits()).extracting(EditResult::figure).doesNotContain("").hasSize(15);
    }

    @Test
    void report_isMadeAgainOfKeptResults() throws Exception {
        bench(scene, "--figure", 21).isDone();
        Path page = out.resolve("report.html");
        String first = Files.readString(page);
        Files.delete(page);
        assertThat(Cli.run("bench", "--report", out.resolve("results.json")).isDone().out()).contains("report.html");
        assertThat(page).hasContent(first);

        Path elsewhere = folder.resolve("elsewhere");
        Cli.run("bench", "--report", out.resolve("results.json"), "-o", elsewhere).isDone();
        assertThat(elsewhere.resolve("report.html")).as("with the pictures beside the results").hasContent(first);
    }

    @Test
    void reportOfAScene_isRefused() throws Exception {
        bench(scene, "--figure", 21).isDone();
        Cli.run("bench", scene, "--report", out.resolve("results.json")).isRefusedSaying("--report", "measures no scene");
        Cli.run("bench", "--report", folder.resolve("none.json")).isRefusedSaying("none.json: there is no such file");
    }

    @Test
    void tablesOfWhatThereIs_areWrittenWhileTheRunGoesOn_thePageAtItsEnd() throws Exception {
        bench(scene, "--figure", 21).isDone();
        Path kept = Files.createDirectory(folder.resolve("kept"));
        BenchFolder files = new BenchFolder(kept, Report::write);
        files.writeNowAndThen(results());
        assertThat(kept).isDirectoryNotContaining(file -> file.endsWith("report.html"));
        assertThat(ResultsFile.readJson(kept.resolve("results.json"))).isEqualTo(results());
        assertThat(kept.resolve("results.csv")).exists();
        files.write(results());
        assertThat(kept.resolve("report.html")).exists();
    }

    @Test
    void interruptedThread_stillKeepsResults() throws Exception {
        bench(scene, "--figure", 21).isDone();
        Results results = results();
        Path kept = Files.createDirectory(folder.resolve("kept"));
        Thread.currentThread().interrupt();
        new BenchFolder(kept, Reporter.NONE).keep(results, () -> assertThat(kept.resolve("results.csv")).exists());
        assertThat(Thread.interrupted()).isTrue();
        assertThat(ResultsFile.readJson(kept.resolve("results.json"))).isEqualTo(results);
    }

    @Test
    void cancelledRun_saysSo() {
        Thread.currentThread().interrupt();
        Cli run = bench(scene);
        assertThat(Thread.interrupted()).isTrue();
        assertThat(run.exit()).isEqualTo(130);
        assertThat(run.err()).endsWith("lightning: cancelled\n");
    }
}
