package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import javax.xml.parsers.DocumentBuilderFactory;
import lightning.bench.report.HtmlReport;
import lightning.bench.result.BenchResults;
import lightning.bench.result.BenchRun;
import lightning.bench.result.EditResult;
import lightning.bench.result.MeasurementFailure;
import lightning.bench.result.ResultsArbitraries;
import lightning.bench.result.SampleResults;
import lightning.bench.result.SceneResult;
import lightning.bench.result.SweepPointResult;
import lightning.bench.result.SystemLoad;
import lightning.bench.result.ValueResult;
import lightning.format.image.ImageFile;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.measure.AccuracySetting;
import lightning.render.measure.PictureError;
import lightning.sample.TryFolder;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.InputSource;

class HtmlReportTest {
    @TempDir
    private Path folder;

    @Property(tries = 15)
    void anyResults_giveSelfContainedPage(@ForAll long seed) throws Exception {
        try (TryFolder files = new TryFolder()) {
            assertWellFormed(write(ResultsArbitraries.of(seed), files.path()));
        }
    }

    @Test
    void emptyResults_giveAPage() throws Exception {
        Document page =
                write(new BenchResults(SampleResults.RUN, List.of(), List.of(), List.of(), List.of(), List.of(), List.of(), List.of()),
                        folder);

        assertWellFormed(page);
        assertThat(page.getDocumentElement().getTextContent()).contains("Seed 1", "Java 25");
    }

    @Test
    void canceledRun_isMarked() throws Exception {
        BenchResults part =
                new BenchResults(SampleResults.RUN.withOutcome(5, false, SampleResults.RUN.load()), List.of(SampleResults.scene(10)),
                        List.of(), List.of(), List.of(),
                        List.of(), List.of(), List.of());

        assertThat(write(part, folder).getDocumentElement().getTextContent()).contains("had not ended after 5.00 s: it was canceled",
                "bird, 300 × 200");
    }

    /** Returns a scene of edits with these savings of a 100 ms full trace, at the default setting and without updated reflections. */
    private static SceneResult scene(double... savings) {
        var same = new PictureError(0, 300, 0, 0, 0, 0, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, 1, 0);
        var stale = new PictureError(7, 300, 0, 0.1, 0.1, 0.1, 20, 20, 0.9, 0.1);
        List<EditResult> edits = new ArrayList<>();
        for (double saving : savings) {
            double ms = Double.isNaN(saving) ? 100 : 100 - saving;
            var rungs = List.of(new SweepPointResult(AccuracySetting.EXACT, SampleResults.samples(1, 1, 1), 99, stale, null, null, null),
                    new SweepPointResult(AccuracySetting.DEFAULT, SampleResults.samples(ms, ms, ms), saving, same, null, null, null),
                    new SweepPointResult(AccuracySetting.FULL_TRACE, SampleResults.samples(100, 100, 100), 0, same, null, null, null));
            edits.add(new EditResult("edit" + edits.size(), "Fig. 6", 98, saving, 90, List.of(new ValueResult("value", rungs))));
        }
        return new SceneResult("bird", 300, 200, 3, 10, 3, null, null, edits, List.of(), null, null);
    }

    private static BenchResults results(BenchRun run, SceneResult... scenes) {
        return new BenchResults(run, List.of(scenes), List.of(), List.of(), List.of(), List.of(), List.of(), List.of());
    }

    private static BenchRun run(SystemLoad load, int repetitions) {
        BenchRun run = SampleResults.RUN;
        return new BenchRun(run.date(), run.commit(), run.arguments(), run.machine(), load, 1, 2, repetitions, false, 1, 1, true, 40,
                List.of(40.0));
    }

    @Test
    void headlines_useAndNameDefaultSetting() throws Exception {
        Element key = byClass(write(results(SampleResults.RUN, scene(60, 80, 90)), folder), "key").getFirst();

        assertThat(texts(key, "dt").subList(0, 3)).containsExactly("80.0\u00a0%", "60.0\u00a0%", "3 of 3");
        assertThat(texts(key, "dd").subList(0, 3))
                .allSatisfy(text -> assertThat(text).contains("at setting " + AccuracySetting.DEFAULT.label()));
        assertThat(texts(key, "dd").get(1)).contains("edit0 on bird");
    }

    @Test
    void uncertainSaving_isNotInHeadline() throws Exception {
        Element key = byClass(write(results(SampleResults.RUN, scene(Double.NaN, 80, Double.NaN)), folder), "key").getFirst();
        assertThat(texts(key, "dt").subList(0, 2)).containsExactly("80.0\u00a0%", "80.0\u00a0%");
        assertThat(texts(key, "dd").getFirst()).contains("2 of 3 edits are left out");

        key = byClass(write(results(SampleResults.RUN, scene(Double.NaN)), folder), "key").getFirst();
        assertThat(texts(key, "dt").subList(0, 2)).containsExactly("–", "–");
    }

    @Test
    void busyMachine_isReported() throws Exception {
        String busy = write(results(run(new SystemLoad(3, 9, 0.53), 5), scene(80)), folder).getDocumentElement().getTextContent();
        assertThat(busy).contains("This machine was busy", "53.0\u00a0%");
        String quiet = write(results(run(new SystemLoad(3, 2, 0.01), 5), scene(80)), folder).getDocumentElement().getTextContent();
        assertThat(quiet).doesNotContain("busy").contains("1.0\u00a0%");
    }

    @Test
    void oneRepetition_isNotCalledWarm() throws Exception {
        SystemLoad load = SampleResults.RUN.load();
        assertThat(write(results(run(load, 1), scene(80)), folder).getDocumentElement().getTextContent()).contains("nothing warmed up")
                .doesNotContain("after a warm-up");
        assertThat(write(results(run(load, 5), scene(80)), folder).getDocumentElement().getTextContent())
                .contains("5 samples each, after a warm-up");
    }

    @Test
    void barsOfLosses_endInsideChart() throws Exception {
        // An edit ten times as slow as the full trace.
        Document page = write(results(SampleResults.RUN, scene(80, -900)), folder);
        Element chart = elements(page.getElementsByTagName("svg")).getFirst();
        List<Double> widths = elements(chart.getElementsByTagName("rect")).stream()
                .map(bar -> Double.parseDouble(bar.getAttribute("width"))).toList();
        double longest = Collections.max(widths);
        // Bars of 1000 and of 20 percent.
        assertThat(widths).anySatisfy(width -> assertThat(longest / width).isCloseTo(1000 / 20.0, withinPercentage(2)));
        assertThat(texts(chart, "text")).contains("1000.0\u00a0%");
    }

    @Test
    void failure_hasItsOwnLine() throws Exception {
        BenchResults results =
                new BenchResults(SampleResults.RUN, List.of(SampleResults.scene(10)), List.of(), List.of(), List.of(), List.of(), List.of(),
                        List.of(new MeasurementFailure(MeasurementFailure.Kind.UNREAD, "a.jen:12:8", "intensity must be ≥ 0, was -3"),
                                new MeasurementFailure(MeasurementFailure.Kind.UNREAD, "b.jen", "no such file")));
        Element problems = byId(write(results, folder), "problems");

        assertThat(texts(problems, "li")).hasSize(2).first().asString().contains("a.jen:12:8", "intensity must be ≥ 0, was -3");
    }

    @Test
    void namesWithMarkup_areEscaped() throws Exception {
        String name = "<script>alert('\"&')</script>";
        SceneResult scene = SampleResults.scene(10);
        Document page = write(
                new BenchResults(SampleResults.RUN,
                        List.of(new SceneResult(name, 300, 200, 3, 10, 3, null, null, scene.edits(), List.of(), null, null)),
                        List.of(), List.of(), List.of(), List.of(), List.of(), List.of()),
                folder);

        assertThat(byId(page, "scene-1").getElementsByTagName("h2").item(0).getTextContent()).isEqualTo(name + ", 300 × 200");
        assertThat(page.getElementsByTagName("script").getLength()).isEqualTo(1);
    }

    @Test
    void pictures_haveWipeAndSideBySideView() throws Exception {
        for (String picture : List.of("before.png", "after.png", "full.png", "difference.png")) {
            ImageFile.write(folder.resolve(picture), Film.ofScanlines(1, 1, new float[] {picture.length() / 20f, 0, 0}),
                    ViewTransform.DEFAULT);
        }
        var error = new PictureError(1, 3, 1, 0.1, 0.1, 0.1, 20, 20, 0.9, 0.1);
        var none = new PictureError(0, 3, 0, 0, 0, 0, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, 1, 0);
        var rungs = List.of(
                new SweepPointResult(AccuracySetting.EXACT, SampleResults.samples(2, 3), 70, error, null, "after.png", "difference.png"),
                new SweepPointResult(AccuracySetting.FULL_TRACE, SampleResults.samples(9, 10), 0, none, null, "full.png", null));
        var edit = new EditResult("color", "Fig. 6", 98, 70, 90, List.of(new ValueResult("sun: color 1 1 1 → 1 0 0, on yes → no", rungs)));
        var scene = new SceneResult("bird", 1, 1, 3, 10, 3, "before.png", null, List.of(edit), List.of(), null, null);
        Document page =
                write(new BenchResults(SampleResults.RUN, List.of(scene), List.of(), List.of(), List.of(), List.of(), List.of(), List.of()),
                        folder);

        assertWellFormed(page);
        assertThat(texts(byClass(page, "wipe").getFirst(), "option")).containsExactly("before", "exact", "full trace",
                "before", "exact", "full trace", "exact");
        assertThat(texts(byClass(page, "side").getFirst(), "figcaption")).containsExactly("before", "exact", "full trace",
                "difference, false colors");
    }

    @Test
    void missingPictures_areLeftOut() throws Exception {
        SceneResult scene = SampleResults.scene(10);
        Document page = write(
                new BenchResults(SampleResults.RUN,
                        List.of(new SceneResult("bird", 300, 200, 3, 10, 3, "gone.png", null, scene.edits(), List.of(),
                                null, null)),
                        List.of(), List.of(), List.of(), List.of(), List.of(), List.of()),
                folder);

        assertThat(byClass(page, "wipe")).isEmpty();
        assertThat(page.getDocumentElement().getTextContent()).contains("sun: color 1 1 1 → 1 0 0, on yes → no");
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void noFonts_replaceEachChartByText() throws Exception {
        Path none = Files.writeString(folder.resolve("fonts.conf"), "<?xml version=\"1.0\"?><fontconfig></fontconfig>");
        ProcessBuilder java = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                System.getProperty("java.class.path"), "--add-modules", "jdk.incubator.vector", "-Duser.home=" + folder,
                FontlessProcess.class.getName(), folder.toString()).redirectErrorStream(true);
        java.environment().put("FONTCONFIG_FILE", none.toString());
        java.environment().put("HOME", folder.toString());
        Process process = java.start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

        assertThat(process.waitFor()).as(said).isZero();
        assertThat(Files.readString(folder.resolve(HtmlReport.FILE)))
                .contains("Java finds no font", "sun: color 1 1 1 → 1 0 0, on yes → no")
                .doesNotContain("<svg class");
    }

    /** Writes a report in a separate process. */
    static final class FontlessProcess {
        private FontlessProcess() {}

        public static void main(String[] folder) throws Exception {
            HtmlReport.write(
                    new BenchResults(SampleResults.RUN, List.of(SampleResults.scene(10)), List.of(), List.of(), List.of(), List.of(),
                            List.of(),
                            List.of()),
                    Path.of(folder[0]));
        }
    }

    private static void assertWellFormed(Document page) {
        List<String> ids = attributes(page, "id");
        assertThat(ids).doesNotHaveDuplicates();
        assertThat(attributes(page, "href")).allSatisfy(link -> assertThat(ids).contains(link.substring(1)));
        assertThat(attributes(page, "src")).isEmpty();
        for (String part : List.of("style", "script")) {
            assertThat(page.getElementsByTagName(part).item(0).getTextContent()).doesNotContain("//www", "http:", "https:", "@import")
                    .doesNotContainPattern("url\\((?!data:|#)");
        }
    }

    private static Document write(BenchResults results, Path folder) throws Exception {
        HtmlReport.write(results, folder);
        String text = Files.readString(folder.resolve(HtmlReport.FILE));
        return DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(new InputSource(new StringReader(text)));
    }

    private static Element byId(Document page, String id) {
        return elements(page.getElementsByTagName("*")).stream().filter(e -> e.getAttribute("id").equals(id)).findFirst().orElseThrow();
    }

    private static List<Element> byClass(Document page, String name) {
        return elements(page.getElementsByTagName("*")).stream().filter(e -> e.getAttribute("class").equals(name)).toList();
    }

    private static List<String> texts(Element in, String tag) {
        return elements(in.getElementsByTagName(tag)).stream().map(Element::getTextContent).toList();
    }

    private static List<String> attributes(Document page, String name) {
        return elements(page.getElementsByTagName("*")).stream().filter(e -> e.hasAttribute(name)).map(e -> e.getAttribute(name)).toList();
    }

    private static List<Element> elements(NodeList nodes) {
        List<Element> elements = new ArrayList<>();
        for (int i = 0; i < nodes.getLength(); i++) {
            elements.add((Element) nodes.item(i));
        }
        return elements;
    }
}
