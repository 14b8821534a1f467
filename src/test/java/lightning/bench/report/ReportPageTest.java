package lightning.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import lightning.bench.result.BenchResults;
import lightning.bench.result.BenchRun;
import lightning.bench.result.ColdStart;
import lightning.bench.result.DriftCurve;
import lightning.bench.result.DriftPoint;
import lightning.bench.result.EditResult;
import lightning.bench.result.EditingCost;
import lightning.bench.result.EffectResult;
import lightning.bench.result.FirstPassResult;
import lightning.bench.result.GrowthCurve;
import lightning.bench.result.GrowthPoint;
import lightning.bench.result.IndirectAbsence;
import lightning.bench.result.IndirectCost;
import lightning.bench.result.IndirectResults;
import lightning.bench.result.MeasurementFailure;
import lightning.bench.result.MeshPoint;
import lightning.bench.result.ModernEdit;
import lightning.bench.result.ModernPicture;
import lightning.bench.result.ModernSampling;
import lightning.bench.result.ModernScene;
import lightning.bench.result.PeerResult;
import lightning.bench.result.RayThroughput;
import lightning.bench.result.ReflectionAccuracy;
import lightning.bench.result.ResultsArbitraries;
import lightning.bench.result.SampleResults;
import lightning.bench.result.SceneResult;
import lightning.bench.result.SweepPointResult;
import lightning.bench.result.SystemLoad;
import lightning.bench.result.TimeSamples;
import lightning.bench.result.UpdateWork;
import lightning.bench.result.ValueResult;
import lightning.format.image.ImageFile;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.measure.AccuracySetting;
import lightning.render.measure.PictureError;
import lightning.render.relight.paper.Accuracy;
import lightning.sample.Slow;
import lightning.scene.PictureSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Reports in a real browser. */
@Slow
class ReportPageTest {
    private static final PictureError SAME =
            new PictureError(0, 300, 0, 0, 0, 0, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, 1, 0);
    private static final PictureError STALE = new PictureError(7, 300, 0, 0.1, 0.1, 0.1, 20, 20, 0.9, 0.1);
    private static final TimeSamples TEN = SampleResults.samples(10, 10, 10);
    /** Names that are markup, script, or words of JavaScript. */
    private static final List<String> HOSTILE = List.of("<script>alert('\"&')</script>", "</script><h1>x", "<img src=x onerror=alert(1)>",
            "{{data}}", "${7*7}", "<!--", "__proto__", "constructor", "NaN", "null", "Infinity", "");

    @TempDir
    private Path folder;

    private static BenchResults results(BenchRun run, SceneResult... scenes) {
        return new BenchResults(run, List.of(scenes), List.of(), List.of(), List.of(), List.of(), List.of(), List.of());
    }

    private static BenchRun run(SystemLoad load, int repetitions) {
        BenchRun run = SampleResults.RUN;
        return new BenchRun(run.date(), run.commit(), run.arguments(), run.machine(), load, 1, 2, repetitions, false, 1, 1, true, 40,
                List.of(40.0));
    }

    private static SceneResult scene(String name, FirstPassResult first, List<EditResult> edits) {
        return new SceneResult(name, 300, 200, 3, 10, 3, null, first, edits, List.of(), null, null);
    }

    /** Returns a scene of edits with these savings of a 100 ms full trace, at the default setting and without updated reflections. */
    private static SceneResult scene(double... savings) {
        List<EditResult> edits = new ArrayList<>();
        for (double saving : savings) {
            double ms = Double.isNaN(saving) ? 100 : 100 - saving;
            var rungs = List.of(new SweepPointResult(AccuracySetting.EXACT, SampleResults.samples(1, 1, 1), 99, STALE, null, null, null),
                    new SweepPointResult(AccuracySetting.DEFAULT, SampleResults.samples(ms, ms, ms), saving, SAME, null, null, null),
                    new SweepPointResult(AccuracySetting.FULL_TRACE, SampleResults.samples(100, 100, 100), 0, SAME, null, null, null));
            edits.add(new EditResult("edit" + edits.size(), "Fig. 6", 98, saving, 90, List.of(new ValueResult("value", rungs))));
        }
        return scene("bird", null, edits);
    }

    private ReportPage open(BenchResults results) throws IOException {
        return ReportPage.open(results, folder);
    }

    /** No script fails, nothing is loaded, links lead to sections, and no value is shown as JavaScript's word for a missing one. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
    void anyResults_giveAPage(long seed) throws IOException {
        try (ReportPage page = open(ResultsArbitraries.of(seed))) {
            page.openEdits();
            assertThat(page.browser().messages()).isEmpty();
            assertThat(page.browser().requests()).allMatch(url -> url.startsWith("file:") || url.startsWith("data:"));
            List<String> ids = page.strings("return [...document.querySelectorAll('[id]')].map(e => e.id)");
            assertThat(ids).doesNotHaveDuplicates();
            assertThat(page.strings("return [...document.querySelectorAll('a')].map(a => a.getAttribute('href').slice(1))")).isNotEmpty()
                    .allSatisfy(target -> assertThat(ids).contains(target));
            assertThat(page.text()).doesNotContain("undefined", "[object");
            assertThat(
                    page.strings("return [...document.querySelectorAll('svg.chart *')].flatMap(e => [...e.attributes].map(a => a.value))"))
                    .allSatisfy(value -> assertThat(value).doesNotContain("NaN", "Infinity", "undefined"));
        }
    }

    @Test
    void emptyResults_giveAPage() throws IOException {
        try (ReportPage page = open(results(SampleResults.RUN))) {
            assertThat(page.text()).contains("Seed 1", "Java 25");
            assertThat(page.strings("return [...document.querySelectorAll('section:not([hidden])')].map(s => s.id)"))
                    .containsExactly("method");
            assertThat(page.texts("nav a")).containsExactly("Method");
        }
    }

    @Test
    void canceledRun_isMarked() throws IOException {
        try (ReportPage page =
                open(results(SampleResults.RUN.withOutcome(5, false, SampleResults.RUN.load()), SampleResults.scene(10)))) {
            assertThat(page.text()).contains("had not ended after 5.00 s: it was canceled", "bird, 300 × 200");
        }
    }

    @Test
    void headlines_useAndNameDefaultSetting() throws IOException {
        try (ReportPage page = open(results(SampleResults.RUN, scene(60, 80, 90)))) {
            assertThat(page.texts("#key dt")).containsExactly("80.0\u00a0%", "60.0\u00a0%", "3 of 3", "–");
            assertThat(page.texts("#key dd").subList(0, 3))
                    .allSatisfy(text -> assertThat(text).contains("at setting " + AccuracySetting.DEFAULT.label()));
            assertThat(page.texts("#key dd").get(1)).contains("edit0 on bird");
        }
    }

    @Test
    void uncertainSaving_isNotInHeadline() throws IOException {
        try (ReportPage page = open(results(SampleResults.RUN, scene(Double.NaN, 80, Double.NaN)))) {
            assertThat(page.texts("#key dt").subList(0, 2)).containsExactly("80.0\u00a0%", "80.0\u00a0%");
            assertThat(page.texts("#key dd").getFirst()).contains("2 of 3 edits are left out");
        }
        try (ReportPage page = open(results(SampleResults.RUN, scene(Double.NaN)))) {
            assertThat(page.texts("#key dt").subList(0, 2)).containsExactly("–", "–");
        }
    }

    @Test
    void differingPicture_isNotCountedAsIdentical() throws IOException {
        var differing = new EditResult("odd", "", 1, 70, 1, List.of(new ValueResult("value",
                List.of(new SweepPointResult(AccuracySetting.DEFAULT, TEN, 70, STALE, null, null, null)))));
        try (ReportPage page = open(results(SampleResults.RUN, scene(60, 80), scene("balls", null, List.of(differing))))) {
            assertThat(page.texts("#key dt").get(2)).isEqualTo("2 of 3");
        }
    }

    @Test
    void savings_areSharesOfTheFullTrace() throws IOException {
        try (ReportPage page = open(results(SampleResults.RUN, scene(60)))) {
            String chart = "[aria-label='Time of each edit, compared with the paper, bird, 300 × 200']";
            assertThat(page.texts(chart + " text")).contains("edit0 (Fig. 6)", "2.0\u00a0%", "40.0\u00a0%", "1.0\u00a0%");
            // The paper's bar, ours of 40 percent, that without updated reflections, and the tick of the limit of 10 percent on ours.
            assertThat(page.strings("""
                    const bars = [...document.querySelectorAll(arguments[0] + " rect")].map(bar => bar.getBBox());
                    const tick = document.querySelector(arguments[0] + " path[stroke='var(--text)']").getBBox();
                    const scale = bars[1].width / 40;
                    return [...bars.map(bar => bar.width), tick.x - bars[1].x].map(v => Math.round(v / scale));""", chart))
                    .containsExactly("2", "40", "1", "10");
        }
    }

    @Test
    void busyMachine_isReported() throws IOException {
        try (ReportPage page = open(results(run(new SystemLoad(3, 9, 0.53), 5), scene(80)))) {
            assertThat(page.texts(".note")).anySatisfy(note -> assertThat(note).contains("This machine was busy", "53.0\u00a0%"));
        }
        try (ReportPage page = open(results(run(new SystemLoad(3, 2, 0.01), 5), scene(80)))) {
            assertThat(page.text()).doesNotContain("busy").contains("1.0\u00a0%");
        }
    }

    @Test
    void oneRepetition_isNotCalledWarm() throws IOException {
        SystemLoad load = SampleResults.RUN.load();
        try (ReportPage page = open(results(run(load, 1), scene(80)))) {
            assertThat(page.text()).contains("nothing warmed up").doesNotContain("after a warm-up");
        }
        try (ReportPage page = open(results(run(load, 5), scene(80)))) {
            assertThat(page.text()).contains("5 samples each, after a warm-up");
        }
    }

    @Test
    void failure_hasItsOwnLine() throws IOException {
        try (ReportPage page = open(new BenchResults(SampleResults.RUN, List.of(SampleResults.scene(10)), List.of(), List.of(), List.of(),
                List.of(), List.of(), List.of(
                        new MeasurementFailure(MeasurementFailure.Kind.UNREAD, "a.jen:12:8", "intensity must be ≥ 0, was -3"),
                        new MeasurementFailure(MeasurementFailure.Kind.UNREAD, "b.jen", null))))) {
            assertThat(page.texts("#problems li")).containsExactly("a.jen:12:8 intensity must be ≥ 0, was -3", "b.jen ");
        }
    }

    @Test
    void foreignNames_areText() throws IOException {
        SceneResult[] scenes = HOSTILE.stream().map(name -> scene(name, null, List.of(new EditResult(name, "", 98, 75, 90,
                List.of(new ValueResult(name, List.of(
                        new SweepPointResult(AccuracySetting.EXACT, TEN, 75, STALE, null, name, name),
                        new SweepPointResult(AccuracySetting.FULL_TRACE, TEN, 0, SAME, null, name, null))))))))
                .toArray(SceneResult[]::new);
        try (ReportPage page = open(results(SampleResults.RUN, scenes))) {
            page.openEdits();
            assertThat(page.texts(".scene h2")).isEqualTo(HOSTILE.stream().map(name -> name + ", 300 × 200").toList());
            assertThat(page.texts("summary b")).isEqualTo(HOSTILE);
            assertThat(page.texts(".tight caption")).isEqualTo(HOSTILE);
            assertThat(page.texts(".plans tbody th")).isEqualTo(HOSTILE);
            assertThat(page.texts("main script, main img, main h1")).isEmpty();
            assertThat(page.browser().messages()).isEmpty();
        }
    }

    @Test
    void overview_comparesFirstPassAndFullTrace() throws IOException {
        var first =
                new FirstPassResult(SampleResults.samples(30, 30, 30), SampleResults.samples(20, 20, 20), 50, 100, 10, 1000, 100, 44.7, 3);
        try (ReportPage page = open(results(SampleResults.RUN, scene("bird", first, scene(60, 80, 90, Double.NaN).edits()), scene()))) {
            assertThat(page.row("Medians.", "bird")).containsExactly("300 × 200", "3", "10", "20.0\u00a0ms", "30.0\u00a0ms", "50.0\u00a0%",
                    "44.7", "3 edits", "80.0\u00a0%", "60.0\u00a0%", "90.0\u00a0%");
            assertThat(page.texts("#overview tr:last-child td").subList(3, 11)).containsOnly("–");
            assertThat(page.texts("#key dt").get(3)).isEqualTo("50.0\u00a0%");
            assertThat(page.texts("#scene-1 .lead").getFirst()).contains("The full trace takes 20.0\u00a0ms, the first pass 30.0\u00a0ms",
                    "1.0\u00a0kB, 44.7 bytes per pixel");
            assertThat(page.texts("#scene-1 .chart:first-of-type text")).contains("first pass", "118.8\u00a0%", "150.0\u00a0%");
        }
    }

    @Test
    void settings_showMedianTimeAndWorstErrorOfAllEdits() throws IOException {
        var worse = new PictureError(30, 300, 12345, 0.5, 0.25, 0.3, 10, 12, 0.8, 0.2);
        List<ValueResult> values = new ArrayList<>();
        for (int i = 1; i <= 3; i++) {
            values.add(new ValueResult("value " + i, List.of(new SweepPointResult(AccuracySetting.RATIO, SampleResults.samples(i, i, i),
                    i == 2 ? Double.NaN : 10 * i, i == 2 ? worse : STALE, null, null, null))));
        }
        try (ReportPage page =
                open(results(SampleResults.RUN, scene("bird", null, List.of(new EditResult("color", "", 1, 2, 3, values)))))) {
            assertThat(page.row("Each accuracy setting", "ratio")).containsExactly("2.00\u00a0ms", "10.0\u00a0%", "10.0\u00a0%",
                    "12\u202f345", "0.500", "0.250", "0.300", "10.0\u00a0dB", "12.0\u00a0dB", "0.80000", "0.200");
            assertThat(page.texts(".settings dt")).containsExactly("ratio");
            assertThat(page.texts(".settings dd")).containsExactly(AccuracySetting.RATIO.description());
        }
    }

    @Test
    void edits_showWorkSavingsAndLimits() throws IOException {
        var work = new UpdateWork("sun: weight", 1234, 5, 67, 1, 1, 1, 33.9, 1, 1);
        var points = List.of(new SweepPointResult(AccuracySetting.DEFAULT, TEN, 66, SAME, work, null, null),
                new SweepPointResult(AccuracySetting.EXACT, TEN, 74, STALE, null, null, null),
                new SweepPointResult(AccuracySetting.FULL_TRACE, SampleResults.samples(20, 20, 20), 0, SAME, null, null, null));
        var less = List.of(new SweepPointResult(AccuracySetting.EXACT, TEN, 70, STALE, null, null, null));
        var edit = new EditResult("color", "Fig. 6", 98, -5, 90, List.of(new ValueResult("red", points), new ValueResult("blue", less)));
        try (ReportPage page = open(results(SampleResults.RUN, scene("bird", null, List.of(edit))))) {
            assertThat(page.row("Each edit at setting", "color")).containsExactly("sun: weight", "1\u202f234", "5", "67", "10.0\u00a0ms",
                    "20.0\u00a0ms", "−5.0\u00a0%", "98.0\u00a0%", "90.0\u00a0%", "72.0\u00a0%", "–", "×\u202f33.9");
            assertThat(page.texts(".plans td.loss")).containsExactly("−5.0\u00a0%");
            assertThat(page.texts("summary")).containsExactly("color Fig. 6 · saves −5.0\u00a0%, the paper 98.0\u00a0%");
        }
    }

    @Test
    void effectsPeersAndColdStarts_areShown() throws IOException {
        var effects = List.of(new EffectResult("fog", true, List.of("lamp", "sun", "sky"), 5, 1, 2, 2, 1500, 1234),
                new EffectResult("gobos", false, List.of(), 1, -9, 2, 2, 0, 0));
        var peer = new PeerResult("POV-Ray", TEN, TEN, 2.5, 0.99, "two levels", List.of("fog", "gobo"));
        var cold = new ColdStart(TEN, SampleResults.samples(20), new ColdStart.Rival("POV-Ray", SampleResults.samples(40), null, 0.25));
        try (ReportPage page = open(
                results(SampleResults.RUN, new SceneResult("bird", 3, 2, 3, 10, 3, null, null, List.of(), effects, peer, cold)))) {
            assertThat(page.row("Effects in use", "fog")).containsExactly("5.00\u00a0ms", "± 2.00\u00a0ms", "–", "1.5\u00a0kB",
                    "1\u202f234",
                    "lamp and 2 more");
            assertThat(page.row("Absent effects", "gobos")).containsExactly("–", "± 2.00\u00a0ms", "−9.00\u00a0ms", "0.0\u00a0kB", "0", "");
            assertThat(page.text()).contains(
                    "Full trace by POV-Ray: 10.0\u00a0ms, by Lightning: 10.0\u00a0ms, 2.50 times as fast. The images "
                            + "agree in 99.0\u00a0% of pixels (two levels). Not exactly converted: fog; gobo.",
                    "takes 10.0\u00a0ms and 20.0\u00a0ms of processor time; a process of POV-Ray takes 40.0\u00a0ms, so Lightning takes "
                            + "25.0\u00a0% of its time.");
        }
    }

    @Test
    void otherMeasurements_haveTheirSections() throws IOException {
        var growth = new GrowthCurve("lights", "room", List.of(new GrowthPoint(1, TEN, List.of(new GrowthPoint.EditTime("undo", TEN))),
                new GrowthPoint(10, TEN, List.of(new GrowthPoint.EditTime("undo", TEN)))));
        var mesh = new MeshPoint(2000, 1, 41, TEN, List.of(new RayThroughput("eye", 5000, TEN, null, Double.NaN)), null);
        var edit = new ModernEdit("color", "red", TEN, SampleResults.samples(20), 50, true);
        var modern = new ModernScene("hall", List.of(new ModernPicture(ModernSampling.EDGES, 1, 1, null, List.of(edit), 1, 1, null)),
                List.of(), List.of());
        var indirect = new IndirectResults(List.of(), List.of(new IndirectCost("hall", 1, 1, 1, "", TEN, TEN, TEN, 1, 1, 1,
                List.of(new IndirectCost.Edit("color", "red", TEN, SampleResults.samples(4), true)))), List.of(),
                List.of(new IndirectAbsence("room", 1, 1, 0, 7, true, TEN, SampleResults.samples(11))), List.of(), List.of());
        try (ReportPage page = open(new BenchResults(SampleResults.RUN, List.of(), List.of(), List.of(growth),
                List.of(new EditingCost(1000, 10, TEN, TEN, TEN, TEN, TEN, 160, Double.NaN)), List.of(mesh), List.of(modern), indirect,
                List.of()))) {
            assertThat(page.texts("nav a")).containsExactly("Growth", "Editing large scenes", "Ray tracing of meshes", "Modern scenes",
                    "Indirect light", "Method");
            assertThat(page.texts("#growth text")).contains("full trace", "undo");
            assertThat(page.row("Scene operations", "1\u202f000, 10").subList(4, 7)).containsExactly("10.0\u00a0ms", "160\u00a0B", "–");
            assertThat(page.row("Million rays", "2\u202f000, eye")).containsExactly("0.500", "–", "–");
            assertThat(page.row("BVH build", "2\u202f000")).containsExactly("10.0\u00a0ms", "–", "41.0", "–");
            assertThat(page.row("Updates after", "hall, edges 4×4, color")).containsExactly("10.0\u00a0ms", "20.0\u00a0ms", "50.0\u00a0%");
            assertThat(page.texts("#indirect table:first-of-type tbody tr")).contains("hall, color10.0\u00a0ms4.00\u00a0ms10.0\u00a0ms");
            assertThat(page.row("Scenes without", "room")).containsExactly("0", "7", "10.0\u00a0ms", "11.0\u00a0ms");
        }
    }

    @Test
    void drift_showsErrorsAndTheBoundOfRatio() throws IOException {
        var points = List.of(new DriftPoint(Accuracy.RATIO, 1, STALE, 0.2, 0), new DriftPoint(Accuracy.RATIO, 10, STALE, 0.3, 2),
                new DriftPoint(Accuracy.EXACT, 1, SAME, 0, 0), new DriftPoint(Accuracy.EXACT, 10, SAME, 0, 0));
        try (ReportPage page =
                open(new BenchResults(SampleResults.RUN, List.of(), List.of(new DriftCurve("bird", 3, 2, 1, points)), List.of(),
                        List.of(), List.of(), List.of(), List.of()))) {
            assertThat(page.texts("#drift text")).contains("ratio", "ratio, bound", "exact");
            assertThat(
                    page.strings("return [...document.querySelectorAll('#drift [stroke-dasharray]')].map(p => p.getAttribute('stroke'))"))
                    .containsExactly("var(--purple)");
            assertThat(page.texts("#drift figcaption").getFirst()).contains("bird, 3 × 2", "recomputed 2 times.");
        }
    }

    @Test
    void growthWithManyEdits_namesTypicalOnes() throws IOException {
        List<GrowthPoint.EditTime> edits =
                Stream.of("undo", "color", "position", "off", "on", "solo", "add").map(edit -> new GrowthPoint.EditTime(edit, TEN))
                        .toList();
        var growth = new GrowthCurve("lights", "room", List.of(new GrowthPoint(0, TEN, edits), new GrowthPoint(10, TEN, edits)));
        try (ReportPage page =
                open(new BenchResults(SampleResults.RUN, List.of(), List.of(), List.of(growth), List.of(), List.of(), List.of(),
                        List.of()))) {
            assertThat(page.texts("#growth text")).contains("full trace", "color", "position", "add").doesNotContain("undo", "off");
            assertThat(page.texts("#growth [stroke='var(--paper)']")).hasSize(4);
            assertThat(page.texts("#growth figcaption").getFirst()).contains("Gray: the other edits.");
        }
    }

    @Test
    void defaultSettings_areFilled() throws IOException {
        int usual = PictureSettings.REFLECTION_RAYS.initial();
        var blurred = new ReflectionAccuracy("hall", 1, 1, 1, List.of(new ReflectionAccuracy.Point(usual, 1, TEN, 0.1, 0.1, 0.1, 0.1),
                new ReflectionAccuracy.Point(2 * usual, 1, TEN, 0.05, 0.1, 0.1, 0.1)));
        var indirect = new IndirectResults(List.of(), List.of(), List.of(), List.of(), List.of(), List.of(blurred));
        try (ReportPage page = open(new BenchResults(SampleResults.RUN, List.of(scene(60)), List.of(), List.of(), List.of(), List.of(),
                List.of(), indirect, List.of()))) {
            String fills = "return [...document.querySelectorAll(arguments[0] + ' [transform]')].map(p => p.getAttribute('fill'))";
            assertThat(page.strings(fills, "#indirect")).containsExactly("var(--ours)", "none");
            assertThat(page.texts("#indirect figcaption").getFirst()).contains("hall, blurred reflections", "labels are rays");
            // Setting exact has old reflections.
            assertThat(page.strings(fills, "#scene-1 figure")).containsExactly("none", "var(--ours)", "var(--text)");
        }
    }

    private SceneResult sceneWithPictures() throws IOException {
        for (String picture : List.of("before.png", "after.png", "full.png", "difference.png")) {
            ImageFile.write(folder.resolve(picture), Film.ofScanlines(1, 1, new float[] {picture.length() / 20f, 0, 0}),
                    ViewTransform.DEFAULT);
        }
        var rungs = List.of(new SweepPointResult(AccuracySetting.EXACT, SampleResults.samples(2, 3), 70, STALE, null, "after.png",
                "difference.png"),
                new SweepPointResult(AccuracySetting.DEFAULT, SampleResults.samples(3, 4), 60, SAME, null, "full.png", null),
                new SweepPointResult(AccuracySetting.FULL_TRACE, SampleResults.samples(9, 10), 0, SAME, null, "full.png", null));
        var edit = new EditResult("color", "Fig. 6", 98, 70, 90, List.of(new ValueResult("sun: color 1 1 1 → 1 0 0", rungs)));
        return new SceneResult("bird", 1, 1, 3, 10, 3, "before.png", null, List.of(edit, edit), List.of(), null, null);
    }

    @Test
    void pictures_haveWipeAndSideBySideView() throws IOException {
        try (ReportPage page = open(results(SampleResults.RUN, sceneWithPictures()))) {
            page.openEdits();
            assertThat(page.texts("#scene-1-edit-1 .wipe option")).containsExactly("before", "exact", "exact, mirrors current",
                    "full trace",
                    "before", "exact", "exact, mirrors current", "full trace", "exact", "exact, mirrors current");
            assertThat(page.strings("return [...document.querySelectorAll('select')].slice(0, 3).map(s => s.selectedOptions[0].text)"))
                    .containsExactly("before", "exact, mirrors current", "exact, mirrors current");
            assertThat(page.texts("#scene-1-edit-1 .side figcaption")).containsExactly("before", "exact, mirrors current", "full trace");
            assertThat(page.texts("#scene-1-edit-1 .stage p")).containsExactly("bit-identical");
            page.browser().waitFor("return [...document.images].every(image => image.complete)");
            assertThat(page.strings("return [...document.querySelectorAll('.side img')].map(i => `${i.naturalWidth} ${i.alt}`)"))
                    .startsWith("1 before", "1 exact, mirrors current");
            assertThat(page.browser().messages()).isEmpty();
        }
    }

    @Test
    void otherPictureOnTheRight_showsItsDifference() throws IOException {
        try (ReportPage page = open(results(SampleResults.RUN, sceneWithPictures()))) {
            page.openEdits();
            assertThat(page.run("return document.querySelector('.difference').hidden")).isEqualTo(true);
            page.run("const s = document.querySelector('select.right'); s.selectedIndex = 1; s.dispatchEvent(new Event('change'))");
            assertThat(page.run("return document.querySelector('.difference').hidden")).isEqualTo(false);
            assertThat(page.run("return document.querySelector('select.of').selectedOptions[0].text")).isEqualTo("exact");
            assertThat(page.run("return document.querySelector('img.right').alt")).isEqualTo("exact");
            page.run("const c = document.querySelector('.cut'); c.value = 20; c.dispatchEvent(new Event('input'))");
            assertThat(page.run("return getComputedStyle(document.querySelector('img.left')).clipPath").toString()).contains("80%");
        }
    }

    @Test
    void exposure_isOneForThePage() throws IOException {
        try (ReportPage page = open(results(SampleResults.RUN, sceneWithPictures()))) {
            page.openEdits();
            page.run("const e = document.querySelectorAll('.exposure')[1]; e.value = -2; e.dispatchEvent(new Event('input'))");
            assertThat(page.texts("output")).containsExactly("−2 EV", "−2 EV");
            assertThat(page.strings("return [...document.querySelectorAll('.exposure')].map(e => e.value)")).containsExactly("-2", "-2");
            assertThat(page.strings("return [...document.querySelectorAll('#exposed [slope]')].map(e => e.getAttribute('slope'))"))
                    .containsExactly("0.25", "0.25", "0.25");
            assertThat(page.run("return getComputedStyle(document.querySelector('img.left')).filter").toString()).contains("#exposed");
        }
    }

    @Test
    void missingPictures_areLeftOut() throws IOException {
        SceneResult scene = SampleResults.scene(10);
        try (ReportPage page = open(results(SampleResults.RUN,
                new SceneResult("bird", 300, 200, 3, 10, 3, "gone.png", null, scene.edits(), List.of(), null, null)))) {
            page.openEdits();
            assertThat(page.texts(".wipe")).isEmpty();
            assertThat(page.text()).contains("sun: color 1 1 1 → 1 0 0, on yes → no");
        }
    }

    /** The accessibility tree of Chromium. */
    @Test
    void everyControlAndChart_hasAName() throws IOException {
        try (ReportPage page = open(results(SampleResults.RUN, sceneWithPictures()))) {
            page.openEdits();
            JsonNode tree = new JsonMapper()
                    .valueToTree(page.browser().driver().executeCdpCommand("Accessibility.getFullAXTree", Map.of())).get("nodes");
            List<String> named = new ArrayList<>();
            for (JsonNode node : tree) {
                String role = node.at("/role/value").asString("");
                if (!node.path("ignored").asBoolean(false)
                        && List.of("combobox", "slider", "image", "img", "table", "link").contains(role)) {
                    named.add(role);
                    assertThat(node.at("/name/value").asString("")).as("%s", node).isNotBlank();
                }
            }
            assertThat(named).contains("combobox", "slider", "image", "table", "link");
        }
    }

    @Test
    void narrowWindow_scrollsTablesOnly() throws IOException {
        try (ReportPage page = open(results(SampleResults.RUN, sceneWithPictures()))) {
            page.openEdits();
            page.browser().driver().executeCdpCommand("Emulation.setDeviceMetricsOverride",
                    Map.of("width", 360, "height", 800, "deviceScaleFactor", 1, "mobile", false));
            assertThat((Long) page.run("return document.documentElement.scrollWidth")).isLessThanOrEqualTo(360);
        }
    }

    /** Returns red, green and blue of a color that a script returns as CSS. */
    private static int brightness(ReportPage page, String script) {
        return Pattern.compile("\\d+").matcher((String) page.run(script)).results().mapToInt(m -> Integer.parseInt(m.group())).sum();
    }

    @Test
    void darkScreen_hasLightTextOnDark() throws IOException {
        try (ReportPage page = open(results(SampleResults.RUN, scene(60)))) {
            String text = "return getComputedStyle(document.querySelector('.chart text')).fill";
            String paper = "return getComputedStyle(document.body).backgroundColor";
            assertThat(brightness(page, text)).isLessThan(brightness(page, paper));
            page.browser().driver().executeCdpCommand("Emulation.setEmulatedMedia",
                    Map.of("features", List.of(Map.of("name", "prefers-color-scheme", "value", "dark"))));
            assertThat(brightness(page, text)).isGreaterThan(brightness(page, paper));
        }
    }
}
