package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import lightning.base.work.Progress;
import lightning.bench.accuracy.ModernCases;
import lightning.bench.report.IndirectTables;
import lightning.bench.result.BenchResults;
import lightning.bench.result.EffectResult;
import lightning.bench.result.IndirectAccuracy;
import lightning.bench.result.IndirectCost;
import lightning.bench.result.IndirectGrowth;
import lightning.bench.result.SampleResults;
import lightning.bench.result.SoftShadowAccuracy;
import lightning.bench.result.TimeSamples;
import lightning.sample.Nightly;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class IndirectBenchTest {
    private static final PictureSize SMALL = new PictureSize(24, 16);

    @TempDir
    private Path folder;

    /** {@link HarnessTest} runs the other parts of a benchmark in the usual check. */
    @Test
    @Nightly
    void quickRun_measuresRoomAndGrowth() throws Exception {
        BenchSettings settings = BenchSettings.quick(2, 1).indirectOnly().withRepetitions(1);
        Harness harness = new Harness(settings, List.of(), List.of(), folder, List.of(), Progress.NONE);
        BenchResults results = harness.run((_, _) -> {}, Progress.NONE);

        assertThat(results.problems()).isEmpty();
        IndirectAccuracy accuracy = results.indirect().accuracy().getFirst();
        assertThat(accuracy.scene()).isEqualTo(IndirectBench.ROOM);
        assertThat(accuracy.grid()).hasSize(8);
        assertThat(accuracy.byBounces()).extracting(IndirectAccuracy.Point::bounces).containsExactly(1, 2, 4);
        assertThat(accuracy.byBounces()).extracting(p -> p.error().missing()).isSortedAccordingTo((a, b) -> Double.compare(b, a));
        assertThat(accuracy.initial().orElseThrow().error().mean()).isBetween(0.0, 0.2);
        assertThat(results.indirect().softShadows()).singleElement().satisfies(shadows -> {
            assertThat(shadows.scene()).isEqualTo(IndirectBench.ROOM);
            assertThat(shadows.points()).extracting(SoftShadowAccuracy.Point::samples).containsExactly(4, 8, 16, 32, 64);
            assertThat(shadows.points().getFirst().mean()).isGreaterThan(2 * shadows.points().getLast().mean()).isBetween(0.0, 0.5);
        });
        IndirectCost cost = results.indirect().costs().getFirst();
        assertThat(cost.edits()).extracting(IndirectCost.Edit::edit).contains(ModernCases.COLOR, ModernCases.INTENSITY,
                ModernCases.POSITION, ModernCases.MATERIAL_COLOR, ModernCases.SHAPE_MOVED);
        assertThat(cost.edits()).allMatch(IndirectCost.Edit::equal);
        assertThat(cost.bytesPerPixel()).isPositive();
        assertThat(results.indirect().absence()).singleElement().satisfies(absence -> {
            assertThat(absence.bytes()).isZero();
            assertThat(absence.rays()).isZero();
            assertThat(absence.equal()).isTrue();
        });
        assertThat(results.indirect().growth()).extracting(IndirectGrowth::along).containsExactly("lights", "gather points", "rays",
                "objects", "triangles", "pixels");
        assertThat(results.indirect().growth()).allSatisfy(growth -> {
            assertThat(growth.points()).hasSize(2).extracting(IndirectGrowth.Point::at).doesNotHaveDuplicates();
            assertThat(growth.points()).extracting(IndirectGrowth.Point::surfels).allMatch(surfels -> surfels > 0);
        });
    }

    /** Other parts must measure the same picture as before a scene had indirect light. */
    @Test
    void otherParts_leaveIndirectLightOut() throws Exception {
        NamedScene plain = new NamedScene("plain", GeneratedScenes.of(1, SMALL, 8, 3, 1), Path.of("plain.jen"));
        NamedScene lit = new NamedScene("lit", plain.withIndirect(Optional.of(IndirectSettings.DEFAULT)), plain.file());
        assertThat(plain.withoutGatheredLight()).isSameAs(plain);
        assertThat(lit.withoutGatheredLight().scene()).isEqualTo(plain.scene());
        assertThat(lit.withoutGatheredLight().options()).containsExactly("--no-indirect");

        BenchSettings settings = new BenchSettings(List.of(SMALL), 0, 1, false, 1, 0, 2, 5, false, false, false, false, false, true, false,
                0, true);
        Harness harness = new Harness(settings, List.of(plain, lit), List.of(), folder, List.of(), Progress.NONE);
        BenchResults results = harness.run((_, _) -> {}, Progress.NONE);
        assertThat(results.problems()).isEmpty();
        assertThat(results.scenes()).extracting(scene -> scene.firstPass().bytes()).hasSize(2).containsOnly(
                results.scenes().getFirst().firstPass().bytes());
        assertThat(results.scenes()).extracting(scene -> scene.firstPass().fullRays()).containsOnly(
                results.scenes().getFirst().firstPass().fullRays());
        assertThat(results.scenes().getLast().effects()).extracting(EffectResult::effect).doesNotContain("indirect light");
    }

    @Test
    void otherParts_leaveBlurredReflectionsOut() {
        Scene scene = GeneratedScenes.of(1, SMALL, 8, 3, 1);
        Scene rough = scene.withMaterials(scene.materials().stream()
                .map(m -> m.withModel(ShadingModel.PRINCIPLED).withRoughness(0.3)).toList());
        NamedScene direct = new NamedScene("rough", rough, Path.of("rough.jen")).withoutGatheredLight();
        assertThat(direct.options()).containsExactly("--without", "blurred-reflections");
        assertThat(direct.scene().materials()).noneMatch(Material::reflectsRoughly);
    }

    @Test
    void slope_isTheExponent() {
        List<IndirectGrowth.Point> points = List.of(point(1, 3), point(4, 6), point(16, 12));
        assertThat(IndirectTables.exponent(points, IndirectGrowth.Point::extraMs)).isEqualTo(0.5, within(1e-12));
        assertThat(IndirectTables.exponent(points, p -> p.intensity().median())).isEqualTo(0, within(1e-12));
        assertThat(IndirectTables.exponent(points.subList(0, 1), IndirectGrowth.Point::extraMs)).isNaN();
    }

    private static IndirectGrowth.Point point(long at, double extraMs) {
        TimeSamples without = SampleResults.samples(2, 2, 2);
        double ms = 2 + extraMs;
        return new IndirectGrowth.Point(at, 10, 20, 30, SampleResults.samples(ms, ms, ms), without, without, without);
    }
}
