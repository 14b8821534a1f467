package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.bench.accuracy.FirstPassCost;
import lightning.bench.result.BenchResults;
import lightning.bench.result.BenchRun;
import lightning.bench.result.EditResult;
import lightning.bench.result.EditingCost;
import lightning.bench.result.EffectResult;
import lightning.bench.result.FirstPassResult;
import lightning.bench.result.GrowthCurve;
import lightning.bench.result.GrowthPoint;
import lightning.bench.result.MeasurementFailure;
import lightning.bench.result.RayThroughput;
import lightning.bench.result.SampleResults;
import lightning.bench.result.SceneResult;
import lightning.bench.result.SweepPointResult;
import lightning.bench.result.ValueResult;
import lightning.format.image.ImageFile;
import lightning.render.image.Film;
import lightning.render.measure.AccuracySetting;
import lightning.render.measure.Timing;
import lightning.render.relight.PictureTooLargeException;
import lightning.sample.Slow;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class HarnessTest {
    private static final PictureSize SMALL = new PictureSize(24, 16);
    private static final PictureSize LARGE = new PictureSize(40, 30);

    @TempDir
    Path folder;

    private final NamedScene scene = new NamedScene("generated", GeneratedScenes.of(1, SMALL, 8, 3, 1), null);

    private static BenchSettings settings(int values, int figure, PictureSize... sizes) {
        return new BenchSettings(List.of(sizes), figure, values, true, 1, 0, 2, 5, false, false, false, false, false, false, false, 0,
                true);
    }

    private Harness harness(BenchSettings settings) {
        return new Harness(settings, List.of(scene),
                List.of(new MeasurementFailure(MeasurementFailure.Kind.UNREAD, "other.jen", "was not read")), folder,
                List.of("--x"),
                Progress.NONE);
    }

    private BenchResults run(BenchSettings settings) throws Exception {
        return harness(settings).run((_, _) -> {}, Progress.NONE);
    }

    private static NamedScene finestScene() {
        Scene scene = GeneratedScenes.of(1, SMALL, 8, 3, 1);
        return new NamedScene("finest", scene.withPicture(scene.picture().withSampling(new SamplingSettings(AntialiasMode.EVERY, 8))),
                null);
    }

    @Test
    void sceneTooLargeAtEverySize_isRejectedBeforeMeasuring() {
        var bar = new Progress() {
            @Override
            public void report(int done, int total) {
                throw new AssertionError("something is measured");
            }

            @Override
            public boolean isCanceled() {
                return false;
            }
        };
        assertThatThrownBy(
                () -> new Harness(settings(1, 13, new PictureSize(16384, 16384)), List.of(finestScene()), List.of(), folder, List.of(),
                        bar))
                .isInstanceOf(PictureTooLargeException.class).message().contains("it would fit with a size of").doesNotContain("--");
    }

    @Test
    void sizeTooLarge_isReportedAndOtherIsMeasured() throws Exception {
        BenchSettings settings = settings(1, 13, SMALL, new PictureSize(16384, 16384));
        BenchResults results =
                new Harness(settings, List.of(finestScene()), List.of(), folder, List.of(), Progress.NONE).run((_, _) -> {}, Progress.NONE);
        assertThat(results.problems()).singleElement().satisfies(problem -> {
            assertThat(problem.kind()).isEqualTo(MeasurementFailure.Kind.UNMEASURED);
            assertThat(problem.where()).isEqualTo("finest at 16384x16384");
        });
        assertThat(results.scenes()).extracting(SceneResult::width).contains(24);
    }

    @Test
    void run_recordsItsSettings() throws Exception {
        BenchRun run = run(settings(1, 13, SMALL)).run();
        assertThat(run.complete()).isTrue();
        assertThat(run.seed()).isEqualTo(5);
        assertThat(run.arguments()).containsExactly("--x");
        assertThat(run.threads()).isEqualTo(2);
        assertThat(run.repetitions()).isEqualTo(1);
        assertThat(run.predictedSeconds()).isPositive();
        assertThat(run.actualSeconds()).isPositive();
        assertThat(run.triadGBs()).isEqualTo(run.triadSamples().stream().mapToDouble(d -> d).max().orElseThrow());
        assertThat(run.date()).matches("\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\dZ");
        assertThat(run.commit()).isNotBlank();
        assertThat(run.machine().processors()).isEqualTo(Runtime.getRuntime().availableProcessors());
        assertThat(run.machine().memoryBytes()).isPositive();
        assertThat(run.machine().vectorBits()).isGreaterThanOrEqualTo(64);
    }

    @Test
    void effectsOnly_measuresNoEdit() throws Exception {
        BenchResults results = run(settings(1, 0, SMALL).effectsOnly());
        assertThat(results.scenes()).hasSize(1);
        assertThat(results.scenes().getFirst().edits()).isEmpty();
        assertThat(results.scenes().getFirst().effects()).extracting(EffectResult::effect).contains("shadows", "anti-aliasing");
        assertThat(results.drift()).isEmpty();
        assertThat(results.growth()).isEmpty();
    }

    @Test
    @Slow
    void figure_isMeasuredWithEachValueAtEachSize() throws Exception {
        BenchResults results = run(settings(3, 24, SMALL, LARGE));
        assertThat(results.scenes()).extracting(SceneResult::width).containsExactly(24, 40);
        for (SceneResult measured : results.scenes()) {
            assertThat(measured.scene()).isEqualTo("generated");
            assertThat(measured.shapes()).isEqualTo(8);
            assertThat(measured.lights()).isEqualTo(3);
            assertThat(measured.firstPass().rows()).isPositive();
            assertThat(measured.edits()).extracting(EditResult::edit).containsExactly("composite-1", "composite-2");
            assertThat(measured.edits()).extracting(EditResult::figure).containsOnly("Fig. 24");
            assertThat(measured.edits()).extracting(EditResult::paperSaving).containsExactly(98.0, 82.0);
            assertThat(measured.edits()).allSatisfy(edit -> assertThat(edit.values()).hasSize(3).extracting(ValueResult::value)
                    .doesNotHaveDuplicates());
        }
    }

    @Test
    @Slow
    void results_includeWorkOfTheirSetting() throws Exception {
        EditResult edit = run(settings(1, 15, LARGE)).scenes().getFirst().edits().getFirst();
        List<SweepPointResult> rungs = edit.values().getFirst().rungs();
        assertThat(edit.edit()).isEqualTo("position");
        assertThat(rungs).extracting(SweepPointResult::grade)
                .containsExactlyElementsOf(EnumSet.complementOf(EnumSet.of(AccuracySetting.FEW_SAMPLES, AccuracySetting.NO_ANTIALIASING)));
        SweepPointResult exact = result(rungs, AccuracySetting.EXACT);
        assertThat(exact.work().plan()).isEqualTo("light0: full recompute");
        assertThat(exact.work().shadowRays()).isPositive();
        assertThat(exact.work().shadowRaysAvoided()).isPositive();
        assertThat(exact.work().floorMs()).isPositive();
        assertThat(exact.work().timesFloor()).isEqualTo(exact.time().median() / exact.work().floorMs());
        assertThat(List.of(edit.saving(), exact.saving())).as("one sample gives no saving").containsOnly(Double.NaN);
        assertThat(edit.cap()).isEqualTo(result(rungs, AccuracySetting.DEFAULT).work().cap());
        assertThat(result(rungs, AccuracySetting.EXACT_CURRENT).error().values()).isZero();
        assertThat(rungs.getLast().work()).isNull();
        assertThat(rungs.getLast().saving()).isZero();
    }

    @Test
    void pictures_areWrittenForFirstSizeAndValue() throws Exception {
        BenchResults results = run(settings(2, 21, SMALL, LARGE));
        SceneResult first = results.scenes().getFirst();
        assertThat(first.before()).isEqualTo("pictures/generated-before.png");
        List<SweepPointResult> rungs = first.edits().getFirst().values().getFirst().rungs();
        SweepPointResult full = rungs.getLast();
        SweepPointResult fast = result(rungs, AccuracySetting.FAST_SHADING);
        SweepPointResult current = result(rungs, AccuracySetting.EXACT_CURRENT);
        assertThat(full.picture()).isEqualTo("pictures/generated-ambience-full.png");
        assertThat(full.difference()).isNull();
        assertThat(current.picture()).isEqualTo(full.picture());
        assertThat(current.difference()).isNull();
        assertThat(fast.picture()).isEqualTo("pictures/generated-ambience-fast-shading.png");
        assertThat(fast.difference()).isEqualTo("pictures/generated-ambience-fast-shading-difference.png");
        for (String file : List.of(first.before(), full.picture(), fast.picture(), fast.difference())) {
            Film film = ImageFile.read(folder.resolve(file));
            assertThat(film.width()).isEqualTo(24);
        }
        assertThat(first.edits().getFirst().values().get(1).rungs()).extracting(SweepPointResult::picture).containsOnlyNulls();
        assertThat(results.scenes().get(1).before()).isNull();
    }

    @Test
    @Slow
    void unprintedEdits_areMeasured() throws Exception {
        assertThat(run(settings(1, 0, SMALL)).scenes().getFirst().edits()).extracting(EditResult::edit).contains("color", "undo",
                "depth-more").hasSizeGreaterThan(20);
    }

    @Test
    void problems_areRecorded() throws Exception {
        assertThat(run(settings(1, 13, SMALL)).problems())
                .containsExactly(new MeasurementFailure(MeasurementFailure.Kind.UNREAD, "other.jen", "was not read"));
    }

    @Test
    void canceledRun_keepsPartialResults() {
        Harness harness = harness(settings(1, 24, SMALL));
        List<String> heard = new ArrayList<>();
        Progress stop = new Progress() {
            @Override
            public void report(int done, int total) {}

            @Override
            public boolean isCanceled() {
                return heard.size() == 2;
            }
        };
        assertThatThrownBy(() -> harness.run((part, _) -> heard.add(part), stop)).isInstanceOf(CancellationException.class);
        assertThat(heard).containsExactly("generated at 24x16, first pass", "generated at 24x16, composite-1");
        BenchResults results = harness.results(false);
        assertThat(results.run().complete()).isFalse();
        assertThat(results.scenes().getFirst().edits()).extracting(EditResult::edit).containsExactly("composite-1");
    }

    @Test
    void progress_increasesToEnd() throws Exception {
        List<Integer> heard = new ArrayList<>();
        harness(settings(1, 24, SMALL)).run((_, _) -> {}, new Progress() {
            @Override
            public void report(int done, int total) {
                heard.add(done);
                assertThat(total).isEqualTo(1000);
            }

            @Override
            public boolean isCanceled() {
                return false;
            }
        });
        assertThat(heard).isSorted();
        assertThat(heard.getLast()).isBetween(990, 1000);
    }

    @Test
    @Slow
    void editingOnly_measuresOnlyLargeScenes() throws Exception {
        BenchResults results = run(settings(1, 0, SMALL).editingOnly());
        assertThat(results.scenes()).isEmpty();
        assertThat(results.growth()).isEmpty();
        assertThat(results.editing()).extracting(EditingCost::shapes).containsExactly(10, 1000);
        assertThat(results.editing()).extracting(EditingCost::lights).containsExactly(10, 100);
        assertThat(results.editing()).allSatisfy(e -> assertThat(List.of(e.load(), e.tree(), e.newScene(), e.plan(), e.hover()))
                .allSatisfy(time -> assertThat(time.median()).isPositive()));
    }

    @Test
    void meshesOnly_measuresOnlyRaysOfEachKind() throws Exception {
        BenchResults results = run(settings(1, 0, SMALL).meshesOnly());
        assertThat(results.scenes()).isEmpty();
        assertThat(results.editing()).isEmpty();
        assertThat(results.meshes()).singleElement().satisfies(mesh -> {
            assertThat(mesh.triangles()).isBetween(9_000, 11_000);
            assertThat(mesh.tree().median()).isPositive();
            assertThat(mesh.rays()).extracting(RayThroughput::rays).containsExactly("eye", "shadow", "mirrored", "single");
            assertThat(mesh.rays()).allSatisfy(pace -> assertThat(pace.time().median()).isPositive());
        });
    }

    @Test
    @Slow
    void growth_hasPointForEachPart() throws Exception {
        ResultCollector ledger = new ResultCollector();
        GrowthBench growth = new GrowthBench(settings(1, 0, SMALL), ledger, 1e7);
        List<BenchPart> parts = growth.parts(new TraceThroughput(1e-4));
        assertThat(parts).extracting(BenchPart::where).contains("growth with pixels, 10000", "growth with lights, 16",
                "growth with shapes, 1000", "growth with depth, 0");
        for (BenchPart part : List.of(parts.getFirst(),
                parts.stream().filter(p -> p.where().contains("depth, 2")).findFirst().orElseThrow())) {
            part.work().measure(Progress.NONE);
        }
        List<GrowthCurve> curves = ledger.results(SampleResults.RUN).growth();
        assertThat(curves).extracting(GrowthCurve::along).containsExactly("pixels", "depth");
        assertThat(curves.getFirst().points().getFirst().at()).isEqualTo(10_000);
        assertThat(curves.getFirst().points().getFirst().edits()).extracting(GrowthPoint.EditTime::edit).contains("color", "add");
        assertThat(curves.getLast().points().getFirst().edits()).extracting(GrowthPoint.EditTime::edit)
                .endsWith("mirrors updated after position");
        assertThat(ledger.results(SampleResults.RUN).problems()).isEmpty();
    }

    @Test
    void payOff_isCountedInEdits() {
        var cost = new FirstPassCost(ms(30), ms(20), 7, 100, 5000, 1, true);
        assertThat(FirstPassResult.of(cost, 50, 4).editsToPayOff()).isEqualTo(3);
        assertThat(FirstPassResult.of(cost, 50, -1).editsToPayOff()).isNaN();
        assertThat(FirstPassResult.of(cost, 50, 4).bytesPerPixel()).isEqualTo(100);
        assertThat(FirstPassResult.of(cost, 50, 4).bytesPerRow()).isEqualTo(50);
    }

    private static Timing ms(double ms) {
        return new Timing(List.of(ms));
    }

    private static SweepPointResult result(List<SweepPointResult> results, AccuracySetting setting) {
        return results.stream().filter(r -> r.grade() == setting).findFirst().orElseThrow();
    }
}
