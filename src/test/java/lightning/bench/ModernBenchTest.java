package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import lightning.base.work.Progress;
import lightning.bench.accuracy.ModernCases;
import lightning.bench.result.BenchResults;
import lightning.bench.result.ErrorCurve;
import lightning.bench.result.ModernEdit;
import lightning.bench.result.ModernPicture;
import lightning.bench.result.ModernSampling;
import lightning.bench.result.ModernScene;
import lightning.format.jen.JenReader;
import lightning.format.pov.PovRayRunner;
import lightning.sample.Nightly;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

@Slow
class ModernBenchTest {
    private static final Path FILE = Path.of("scenes", "softbox.jen");

    @TempDir
    private Path folder;

    private BenchResults run(BenchSettings settings) throws Exception {
        var scene = new NamedScene("softbox", JenReader.read(FILE).scene(), FILE);
        return new Harness(settings, List.of(scene), List.of(), folder, List.of(), Progress.NONE).run((_, _) -> {}, Progress.NONE);
    }

    /** {@link HarnessTest} runs the other parts of a benchmark in the usual check. */
    @Test
    @Nightly
    void quickRun_measuresEachPictureAndEachProgram() throws Exception {
        BenchResults results = run(BenchSettings.quick(2, 1).modernOnly().withRepetitions(1).withProcesses(1));
        assertThat(results.problems()).isEmpty();
        assertThat(results.scenes()).isEmpty();
        ModernScene scene = results.modern().getFirst();
        assertThat(scene.scene()).isEqualTo("softbox");
        assertThat(scene.losses()).isNotEmpty();
        assertThat(scene.pictures()).extracting(ModernPicture::sampling).containsExactly(ModernSampling.NONE, ModernSampling.EDGES);
        boolean hasPovRay = PovRayRunner.find().isPresent();
        assertThat(scene.pictures()).allSatisfy(picture -> {
            assertThat(picture.firstPass().rows()).isPositive();
            assertThat(picture.edits()).extracting(ModernEdit::edit).contains(ModernCases.INTENSITY, ModernCases.SHAPE_MOVED);
            assertThat(picture.edits()).allMatch(ModernEdit::equal);
            assertThat(picture.cold().process().samples()).hasSize(1);
            assertThat(picture.cold().rival() != null).isEqualTo(hasPovRay);
        });
        assertThat(scene.curves()).extracting(ErrorCurve::program)
                .isEqualTo(hasPovRay ? List.of("Lightning", "POV-Ray 3.7") : List.of("Lightning"));
        assertThat(scene.curves()).allSatisfy(curve -> assertThat(curve.points()).hasSize(6).allSatisfy(point -> {
            assertThat(point.time().median()).isPositive();
            assertThat(point.error()).isBetween(0.0, 0.2);
        }));
        ErrorCurve ours = scene.curves().getFirst();
        double rough = ours.find(ModernSampling.NONE.label()).orElseThrow().error();
        assertThat(ours.find(ModernSampling.EDGES.label()).orElseThrow().error()).isLessThan(rough / 2);
    }

    @Test
    void sceneWithoutFile_startsNoProcess() throws Exception {
        PictureSize size = new PictureSize(24, 16);
        var scene = new NamedScene("generated", GeneratedScenes.of(1, size, 8, 3, 1), null);
        BenchSettings settings = BenchSettings.quick(2, 1).modernOnly().withRepetitions(1);
        Harness harness = new Harness(settings, List.of(scene), List.of(), folder, List.of(), Progress.NONE);
        assertThat(harness.run((_, _) -> {}, Progress.NONE).modern().getFirst().pictures()).extracting(ModernPicture::cold)
                .containsOnlyNulls();
    }
}
