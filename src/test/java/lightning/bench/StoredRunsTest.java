package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.bench.result.BenchResults;
import lightning.bench.result.BenchRun;
import lightning.bench.result.EditResult;
import lightning.bench.result.IndirectAbsence;
import lightning.bench.result.IndirectCost;
import lightning.bench.result.IndirectResults;
import lightning.bench.result.ModernEdit;
import lightning.bench.result.ModernPicture;
import lightning.bench.result.ModernSampling;
import lightning.bench.result.ModernScene;
import lightning.bench.result.SampleResults;
import lightning.bench.result.SceneResult;
import lightning.bench.result.SweepPointResult;
import lightning.bench.result.ValueResult;
import lightning.render.measure.AccuracySetting;
import lightning.render.measure.PictureError;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class StoredRunsTest {
    private static final String BUILD = "0123456789012345678901234567890123456789";

    private static BenchResults runAt(String commit, boolean complete, int repetitions, List<SceneResult> scenes) {
        BenchRun run = SampleResults.RUN;
        return new BenchResults(
                new BenchRun(run.date(), commit, run.arguments(), run.machine(), run.load(), 1, 2, repetitions, false, 1, 1, complete, 40,
                        List.of(40.0)),
                scenes, List.of(), List.of(), List.of(), List.of(), List.of(), List.of());
    }

    private static List<String> faultsOf(BenchResults first, BenchResults second) {
        Map<String, BenchResults> parts = new LinkedHashMap<>();
        parts.put("figures", first);
        parts.put("cold", second);
        return new StoredRuns(parts).findFaults();
    }

    private static BenchResults validResults() {
        return runAt(BUILD, true, 5, List.of());
    }

    /** Returns a scene whose image at the default setting has differing values. */
    private static SceneResult scene(long differing) {
        var error = new PictureError(differing, 300, 0, 0, 0, 0, 99, 99, 1, 0);
        var rungs = List.of(new SweepPointResult(AccuracySetting.DEFAULT, SampleResults.samples(1, 2, 3), 80, error, null, null, null),
                new SweepPointResult(AccuracySetting.FULL_TRACE, SampleResults.samples(7, 8, 9), 0, error, null, null, null));
        var edit = new EditResult("color", "Fig. 6", 98, 80, 90, List.of(new ValueResult("sun: color", rungs)));
        return new SceneResult("bird", 10, 10, 3, 10, 3, null, null, List.of(edit), List.of(), null, null);
    }

    @Test
    void storedRuns_areCompleteAndFromOneCleanBuild() throws IOException {
        assertThat(StoredRuns.read(StoredRuns.FOLDER).findFaults()).isEmpty();
        assertThat(StoredRuns.otherFiles(StoredRuns.FOLDER)).as("files in benchmarks/results not written by benchmarks/run")
                .isEmpty();
    }

    @Test
    void runsOfOneBuild_haveNoFaults() {
        assertThat(faultsOf(validResults(), runAt(BUILD, true, 3, List.of(scene(0))))).isEmpty();
    }

    @Test
    void mixedBuilds_areAFault() {
        String other = BUILD.replace('0', 'a');
        assertThat(faultsOf(validResults(), runAt(other, true, 5, List.of()))).singleElement().asString().startsWith("several builds: ")
                .contains(BUILD + "=figures", other + "=cold");
    }

    /** Its document names its own build. */
    @Test
    void indirectLightOfAnotherBuild_isNoFault() {
        Map<String, BenchResults> parts = new LinkedHashMap<>();
        parts.put("figures", validResults());
        parts.put("indirect", runAt(BUILD.replace('0', 'a'), true, 5, List.of()));
        assertThat(new StoredRuns(parts).findFaults()).isEmpty();
    }

    @Test
    void dirtyBuild_isAFault() {
        assertThat(faultsOf(runAt(BUILD + "-dirty", true, 5, List.of()), runAt(BUILD + "-dirty", true, 5, List.of()))).hasSize(2);
        assertThat(faultsOf(runAt("unknown", true, 5, List.of()), runAt("unknown", true, 5, List.of()))).hasSize(2);
        assertThat(faultsOf(runAt("0123456", true, 5, List.of()), runAt("0123456", true, 5, List.of()))).hasSize(2);
    }

    @Test
    void canceledRunFewSamplesOrDifferingPictures_areFaults() {
        assertThat(faultsOf(validResults(), runAt(BUILD, false, 5, List.of()))).containsExactly("cold: the run was canceled");
        assertThat(faultsOf(validResults(), runAt(BUILD, true, 2, List.of()))).singleElement().asString().contains("2 samples");
        assertThat(faultsOf(validResults(), runAt(BUILD, true, 5, List.of(scene(1))))).singleElement().asString()
                .contains("bird, color, sun: color: not equal to the full trace");
    }

    @Test
    void differingModernPicture_isAFault() {
        var edit = new ModernEdit("color", "key: color", SampleResults.samples(1, 2, 3), SampleResults.samples(7, 8, 9), 75, false);
        var scene = new ModernScene("hall", List.of(new ModernPicture(ModernSampling.EDGES, 10, 10, null, List.of(edit), 0, 0, null)),
                List.of(), List.of());
        BenchRun run = validResults().run();
        var results = new BenchResults(run, List.of(), List.of(), List.of(), List.of(), List.of(), List.of(scene), List.of());
        assertThat(faultsOf(validResults(), results))
                .containsExactly("cold: hall, anti-aliasing edges 4×4, color: not equal to the full trace");
    }

    @Test
    void differingIndirectPicture_isAFault() {
        var edit = new IndirectCost.Edit("color", "key: color", SampleResults.samples(4, 5, 6), SampleResults.samples(1, 2, 3), false);
        var cost = new IndirectCost("hall", 10, 10, 1, "2 bounces", SampleResults.samples(7, 8, 9), SampleResults.samples(1, 2, 3),
                SampleResults.samples(7, 8, 9), 40, 10, 100, List.of(edit));
        var absence = new IndirectAbsence("hall", 10, 10, 8, 0, true, SampleResults.samples(1, 2, 3), SampleResults.samples(1, 2, 3));
        var indirect = new IndirectResults(List.of(), List.of(cost), List.of(), List.of(absence), List.of(), List.of());
        var results = new BenchResults(validResults().run(), List.of(), List.of(), List.of(), List.of(), List.of(), List.of(), indirect,
                List.of());
        assertThat(faultsOf(validResults(), results)).containsExactly("cold: hall, indirect light, color: not equal to the full trace",
                "cold: hall: absent indirect light is not free");
    }

    @Test
    void otherFiles_areListed(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("figures.json"), "");
        Files.writeString(folder.resolve("modern.json"), "");
        Files.writeString(folder.resolve("editing.txt"), "");
        Files.writeString(folder.resolve("old.json"), "");
        assertThat(StoredRuns.otherFiles(folder)).containsExactly("editing.txt", "old.json");
    }
}
