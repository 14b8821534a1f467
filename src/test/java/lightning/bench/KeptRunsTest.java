package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.bench.accuracy.Grade;
import lightning.bench.accuracy.PictureError;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class KeptRunsTest {
    private static final String BUILD = "0123456789012345678901234567890123456789";

    private static Results at(String commit, boolean complete, int repetitions, List<SceneResult> scenes) {
        Run run = Sample.RUN;
        return new Results(
                new Run(run.date(), commit, run.arguments(), run.machine(), run.load(), 1, 2, repetitions, false, 1, 1, complete, 40,
                        List.of(40.0)),
                scenes, List.of(), List.of(), List.of(), List.of(), List.of());
    }

    private static List<String> faults(Results first, Results second) {
        Map<String, Results> parts = new LinkedHashMap<>();
        parts.put("figures", first);
        parts.put("cold", second);
        return new KeptRuns(parts).faults();
    }

    private static Results good() {
        return at(BUILD, true, 5, List.of());
    }

    /** A scene whose picture of the default grade differs in some values. */
    private static SceneResult scene(long differing) {
        var error = new PictureError(differing, 300, 0, 0, 0, 0, 99, 99, 1, 0);
        var rungs = List.of(new RungResult(Grade.DEFAULT, Sample.samples(1, 2, 3), 80, error, null, null, null),
                new RungResult(Grade.FULL_TRACE, Sample.samples(7, 8, 9), 0, error, null, null, null));
        var edit = new EditResult("color", "Fig. 6", 98, 80, 90, List.of(new ValueResult("sun: color", rungs)));
        return new SceneResult("bird", 10, 10, 3, 10, 3, null, null, List.of(edit), List.of(), null, null);
    }

    @Test
    void kept_isOfOneCleanBuildAndWhole() throws IOException {
        assertThat(KeptRuns.read(KeptRuns.FOLDER).faults()).isEmpty();
        assertThat(KeptRuns.others(KeptRuns.FOLDER)).as("files of benchmarks/results that no part of benchmarks/run writes").isEmpty();
    }

    @Test
    void runsOfOneBuild_haveNoFault() {
        assertThat(faults(good(), at(BUILD, true, 3, List.of(scene(0))))).isEmpty();
    }

    @Test
    void mixedBuilds_areAFault() {
        String other = BUILD.replace('0', 'a');
        assertThat(faults(good(), at(other, true, 5, List.of()))).singleElement().asString().startsWith("several builds: ")
                .contains(BUILD + "=figures", other + "=cold");
    }

    @Test
    void buildThatNobodyCanFetch_isAFault() {
        assertThat(faults(at(BUILD + "-dirty", true, 5, List.of()), at(BUILD + "-dirty", true, 5, List.of()))).hasSize(2);
        assertThat(faults(at("unknown", true, 5, List.of()), at("unknown", true, 5, List.of()))).hasSize(2);
        assertThat(faults(at("0123456", true, 5, List.of()), at("0123456", true, 5, List.of()))).hasSize(2);
    }

    @Test
    void cancelledRun_tooFewSamplesAndPicturesThatDiffer_areFaults() {
        assertThat(faults(good(), at(BUILD, false, 5, List.of()))).containsExactly("cold: the run was cancelled");
        assertThat(faults(good(), at(BUILD, true, 2, List.of()))).singleElement().asString().contains("2 samples");
        assertThat(faults(good(), at(BUILD, true, 5, List.of(scene(1))))).singleElement().asString()
                .contains("bird, color, sun: color: not equal to the full trace");
    }

    @Test
    void otherFiles_areNamed(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("figures.json"), "");
        Files.writeString(folder.resolve("editing.txt"), "");
        Files.writeString(folder.resolve("old.json"), "");
        assertThat(KeptRuns.others(folder)).containsExactly("editing.txt", "old.json");
    }
}
