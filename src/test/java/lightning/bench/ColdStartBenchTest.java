package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.base.work.Progress;
import lightning.bench.result.BenchResults;
import lightning.bench.result.ColdStart;
import lightning.bench.result.MeasurementFailure;
import lightning.format.pov.PovRayRunner;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

@Slow
class ColdStartBenchTest {
    private static final PictureSize SMALL = new PictureSize(24, 16);

    @TempDir
    private Path folder;

    private BenchResults run(Path file) throws Exception {
        var settings = new BenchSettings(List.of(SMALL), 0, 0, false, 1, 0, 2, 5, false, false, false, false, false, false, false, 2, true);
        var scene = new NamedScene("generated", GeneratedScenes.of(1, SMALL, 8, 3, 1), file);
        return new Harness(settings, List.of(scene), List.of(), folder, List.of(), Progress.NONE).run((_, _) -> {}, Progress.NONE);
    }

    @Test
    void processes_areMeasuredRequestedNumberOfTimes() throws Exception {
        Path file = Files.writeString(folder.resolve("a scene.jen"), "jen 1\nsphere ball { }\nlight lamp point { at 0 3 3 }\n");
        BenchResults results = run(file);
        assertThat(results.problems()).isEmpty();
        ColdStart cold = results.scenes().getFirst().cold();
        assertThat(cold.process().samples()).hasSize(2).allMatch(ms -> ms > 10);
        if (cold.processor() != null) {
            assertThat(cold.processor().samples()).hasSize(2).allMatch(ms -> ms > 10);
        }
        assertThat(cold.rival() != null).isEqualTo(PovRayRunner.find().isPresent());
        if (cold.rival() != null) {
            assertThat(cold.rival().process().samples()).hasSize(2);
            assertThat(cold.rival().share()).isEqualTo(cold.process().median() / cold.rival().process().median());
        }
    }

    @Test
    void failingProcess_isReportedWithReason() throws Exception {
        BenchResults results = run(folder.resolve("none.jen"));
        assertThat(results.scenes().getFirst().cold()).isNull();
        assertThat(results.problems()).singleElement().satisfies(problem -> {
            assertThat(problem.kind()).isEqualTo(MeasurementFailure.Kind.UNMEASURED);
            assertThat(problem.where()).isEqualTo("generated at 24x16, from cold");
            assertThat(problem.what()).startsWith("'lightning render' failed: ").contains("none.jen");
        });
    }

    @Test
    void sceneWithoutFile_startsNoProcess() throws Exception {
        BenchResults results = run(null);
        assertThat(results.scenes().getFirst().cold()).isNull();
        assertThat(results.problems()).isEmpty();
    }
}
