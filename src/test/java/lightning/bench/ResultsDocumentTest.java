package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.bench.report.DocumentCharts;
import lightning.bench.report.IndirectDocumentCharts;
import lightning.bench.report.IndirectTables;
import lightning.bench.report.MarkdownTables;
import lightning.bench.report.ModernDocumentCharts;
import lightning.bench.report.ModernTables;
import lightning.bench.report.ReportStatements;
import lightning.bench.result.BenchResults;
import lightning.bench.result.BenchRun;
import lightning.bench.result.FirstPassResult;
import lightning.bench.result.ResultsArbitraries;
import lightning.bench.result.SampleResults;
import lightning.bench.result.SceneResult;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Tests that the marked tables and values in README.md, docs/results.md, docs/performance.md, docs/modern.md and docs/indirect.md match the stored runs. {@code -Dlightning.write=true}
 * regenerates them, unless the runs must not be published.
 */
class ResultsDocumentTest {
    private static final Path RESULTS = Path.of("docs", "results.md");
    private static final Path README = Path.of("README.md");
    private static final Path PERFORMANCE = Path.of("docs", "performance.md");
    private static final Path MODERN = Path.of("docs", "modern.md");
    private static final Path INDIRECT = Path.of("docs", "indirect.md");
    private static final Path DECISIONS = Path.of("docs", "decisions");
    private static final Path PICTURES = Path.of("docs", "pictures");
    private static final Pattern MARKED = Pattern.compile("(<!-- (table|value): (.+?) -->\n?)(.*?)(<!-- end -->)", Pattern.DOTALL);
    /** Matches table names that refer to another part than their own. */
    private static final Pattern OF_PART = Pattern.compile("(.+), of (\\w+)");
    /** Matches a measured number: one with a fraction, or in percent or milliseconds. */
    private static final Pattern MEASURED = Pattern.compile("(?<![\\w.×§])(\\d+\\.\\d+(?:e-?\\d+)?|\\d+(?= %| ms))");
    private static final Pattern NUMBER = Pattern.compile("\\d+(?:\\.\\d+)?(?:e-?\\d+)?");
    /** Matches measurements of another publication. */
    private static final Pattern QUOTED = Pattern.compile("\\(the paper: [^)]*\\)");
    private static final Pattern COSTS = Pattern.compile("(?s)\n## Results\n(.*?)\n## ");
    /** Matches the measurements that led to a decision. */
    private static final Pattern RECORD = Pattern.compile("(?ms)^## Measurements\n(.*?)(?=^## |\\z)");

    static List<String> names() {
        return MarkdownTables.names();
    }

    static List<String> statements() {
        return ReportStatements.names();
    }

    static List<Path> documents() {
        return List.of(RESULTS, README, PERFORMANCE, MODERN, INDIRECT);
    }

    @ParameterizedTest
    @MethodSource("documents")
    void everyTableAndValue_matchesStoredRuns(Path document) throws IOException {
        StoredRuns kept = StoredRuns.read(StoredRuns.FOLDER);
        assertThat(kept.findFaults()).isEmpty();
        BenchResults own = document.equals(INDIRECT) ? kept.find("indirect").orElse(kept.part("figures")) : kept.part("figures");
        String wanted = regenerate(Files.readString(document), kept, own);
        if (Boolean.getBoolean("lightning.write")) {
            Files.writeString(document, wanted);
        }
        assertThat(Files.readString(document)).isEqualTo(wanted);
        assertThat(wanted).contains(own.run().commit());
    }

    /** @param own results whose build the document names */
    private static String regenerate(String text, StoredRuns storedRuns, BenchResults own) {
        ReportStatements statements = new ReportStatements(own, storedRuns.part("cold"), storedRuns.part("meshes"));
        return MARKED.matcher(text).replaceAll(m -> Matcher.quoteReplacement(
                m.group(1) + (m.group(2).equals("table") ? table(m.group(3), storedRuns) : statements.of(m.group(3))) + m.group(5)));
    }

    private static String table(String name, StoredRuns storedRuns) {
        Matcher other = OF_PART.matcher(name);
        if (name.equals("runs")) {
            return MarkdownTables.runs(storedRuns.commonRuns());
        }
        if (name.equals("indirect run")) {
            return storedRuns.find("indirect").map(results -> MarkdownTables.runs(Map.of("indirect", results.run()))).orElse("");
        }
        if (ModernTables.names().contains(name)) {
            return storedRuns.find("modern").map(results -> new ModernTables(results).of(name)).orElse("");
        }
        if (IndirectTables.names().contains(name)) {
            return storedRuns.find("indirect").map(results -> new IndirectTables(results).of(name)).orElse("");
        }
        if (other.matches()) {
            return new MarkdownTables(storedRuns.part(other.group(2))).of(other.group(1));
        }
        return new MarkdownTables(storedRuns.part(switch (name) {
            case "cold", "editing" -> name;
            case "meshes", "rays" -> "meshes";
            case "effects in use", "effects absent" -> "effects";
            default -> "figures";
        })).of(name);
    }

    private static Map<String, String> labels(String part, BenchResults results) {
        return switch (part) {
            case "figures" -> DocumentCharts.labels(results);
            case "modern" -> ModernDocumentCharts.labels(results);
            case "indirect" -> IndirectDocumentCharts.labels(results);
            default -> throw new IllegalArgumentException(part);
        };
    }

    /**
     * Draws all charts, but compares the measured build only, as the bytes depend on installed fonts. Parts may not be stored.
     *
     * @param prefix beginning of the names of the part's charts
     */
    @ParameterizedTest
    @CsvSource({"figures, results-", "modern, modern-", "indirect, indirect-"})
    @Slow
    void everyChart_matchesStoredRun(String part, String prefix, @TempDir Path folder) throws IOException {
        StoredRuns kept = StoredRuns.read(StoredRuns.FOLDER);
        Map<String, String> charts = new TreeMap<>();
        if (kept.find(part).isPresent()) {
            charts.putAll(DocumentCharts.draw(kept.part(part), labels(part, kept.part(part)), folder));
        }
        if (Boolean.getBoolean("lightning.write") && kept.findFaults().isEmpty()) {
            for (var chart : charts.entrySet()) {
                Files.writeString(PICTURES.resolve(chart.getKey()), chart.getValue());
            }
        }
        assertChartsAreStored(kept.find(part), charts.keySet(), prefix);
    }

    /** The same without a browser. */
    @ParameterizedTest
    @CsvSource({"figures, results-", "modern, modern-", "indirect, indirect-"})
    void everyChartOfAStoredRun_isStored(String part, String prefix) throws IOException {
        Optional<BenchResults> results = StoredRuns.read(StoredRuns.FOLDER).find(part);
        assertChartsAreStored(results, results.map(r -> labels(part, r).keySet()).orElse(Set.of()), prefix);
    }

    private static void assertChartsAreStored(Optional<BenchResults> results, Set<String> names, String prefix) throws IOException {
        try (Stream<Path> files = Files.list(PICTURES)) {
            assertThat(files.map(file -> file.getFileName().toString()).filter(name -> name.startsWith(prefix) && name.endsWith(".svg")))
                    .containsExactlyInAnyOrderElementsOf(names);
        }
        for (String name : names) {
            BenchRun run = results.orElseThrow().run();
            assertThat(PICTURES.resolve(name)).content().contains(run.commit(), run.date());
        }
    }

    @Test
    void everyChartOfResults_isInTheDocument() throws IOException {
        String text = Files.readString(RESULTS);
        assertThat(DocumentCharts.labels(StoredRuns.read(StoredRuns.FOLDER).part("figures")).keySet()).isNotEmpty()
                .allSatisfy(name -> assertThat(text).contains("(pictures/" + name + ")"));
    }

    @Test
    void everyMeasuredNumberOfResults_isInTableOrMarked() throws IOException {
        String text = Files.readString(RESULTS);
        String tables = MARKED.matcher(text).results().map(m -> m.group(4)).collect(Collectors.joining());
        Set<String> shown = NUMBER.matcher(tables).results().map(m -> m.group()).collect(Collectors.toSet());
        assertThat(measuredNumbers(text).filter(n -> !shown.contains(n))).as("numbers in sentences without a table in the document")
                .isEmpty();
    }

    @Test
    void everyMeasuredNumberOfReadme_isMarked() throws IOException {
        Matcher costs = COSTS.matcher(Files.readString(README));
        assertThat(costs.find()).isTrue();
        assertThat(measuredNumbers(costs.group(1))).isEmpty();
        assertThat(MARKED.matcher(costs.group(1)).results().map(m -> m.group(3))).contains("savings in short", "build", "equal pictures");
    }

    @Test
    void everyMeasuredFigureOfThePerformanceGuide_isMarked() throws IOException {
        assertThat(measuredNumbers(Files.readString(PERFORMANCE))).isEmpty();
    }

    @Test
    void everyMeasuredFigureOfTheModernScenes_isMarked() throws IOException {
        assertThat(measuredNumbers(Files.readString(MODERN))).isEmpty();
    }

    @Test
    void everyMeasuredFigureOfIndirectLight_isMarked() throws IOException {
        assertThat(measuredNumbers(Files.readString(INDIRECT))).isEmpty();
    }

    private static Stream<String> measuredNumbers(String text) {
        List<String> figures = new ArrayList<>();
        String plain = QUOTED.matcher(MARKED.matcher(text).replaceAll("")).replaceAll("");
        MEASURED.matcher(plain).results().map(m -> m.group(1)).forEach(figures::add);
        return figures.stream();
    }

    /** Checks that no line starts with a comment, which would end the paragraph in Markdown and disable formatting. */
    @ParameterizedTest
    @MethodSource("documents")
    void markerInSentence_doesNotStartLine(Path document) throws IOException {
        assertThat(Files.readAllLines(document)).noneMatch(line -> line.stripLeading().startsWith("<!-- value:"));
    }

    @ParameterizedTest
    @MethodSource("names")
    void everyTable_worksForAnyRun(String name) {
        for (long seed = 0; seed < 20; seed++) {
            assertThat(new MarkdownTables(ResultsArbitraries.of(seed)).of(name)).startsWith("| ").endsWith("|\n");
        }
    }

    static List<String> modernNames() {
        return ModernTables.names();
    }

    @ParameterizedTest
    @MethodSource("modernNames")
    void everyModernTable_worksForAnyRunAndIsInItsDocument(String name) throws IOException {
        for (long seed = 0; seed < 20; seed++) {
            assertThat(new ModernTables(ResultsArbitraries.of(seed)).of(name)).matches("(?s)|.*\n");
        }
        assertThat(Files.readString(MODERN)).contains("<!-- table: " + name + " -->");
    }

    static List<String> indirectNames() {
        return IndirectTables.names();
    }

    @ParameterizedTest
    @MethodSource("indirectNames")
    void everyIndirectTable_worksForAnyRunAndIsInItsDocument(String name) throws IOException {
        for (long seed = 0; seed < 20; seed++) {
            assertThat(new IndirectTables(ResultsArbitraries.of(seed)).of(name)).matches("(?s)|.*\n");
        }
        assertThat(Files.readString(INDIRECT)).contains("<!-- table: " + name + " -->");
    }

    @ParameterizedTest
    @MethodSource("statements")
    void everyStatement_isSingleLine(String name) throws IOException {
        StoredRuns kept = StoredRuns.read(StoredRuns.FOLDER);
        assertThat(new ReportStatements(kept.part("figures"), kept.part("cold"), kept.part("meshes")).of(name)).isNotEmpty().doesNotContain(
                "\n",
                "null", "NaN", "Infinity");
    }

    @Test
    void differingPicture_isNotCalledEqual() {
        SceneResult scene = SampleResults.scene(10);
        FirstPassResult first =
                new FirstPassResult(SampleResults.samples(3, 3, 3), SampleResults.samples(2, 2, 2), 50, 100, 10, 1000, 100, 1, 1);
        BenchResults results = new BenchResults(SampleResults.RUN,
                List.of(new SceneResult("bird", 300, 200, 3, 10, 3, null, first, scene.edits(), List.of(),
                        null, null)),
                List.of(), List.of(), List.of(), List.of(), List.of(), List.of());
        // The sample has no image at the default setting, so nothing was compared.
        assertThatThrownBy(() -> new ReportStatements(results, results, results).of("equal pictures"))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageStartingWith("bird, color, ");
    }

    /** Checks the tables of decisions, which come from many builds. */
    @Test
    void everyTableOfADecisionsMeasurements_namesItsDateAndCommit() throws IOException {
        int records = 0;
        try (Stream<Path> decisions = Files.list(DECISIONS)) {
            for (Path decision : decisions.filter(file -> file.toString().endsWith(".md")).sorted().toList()) {
                Matcher section = RECORD.matcher(Files.readString(decision));
                while (section.find()) {
                    assertDated(decision, section.group(1).lines().toList());
                    records++;
                }
            }
        }
        assertThat(records).isPositive();
    }

    private static void assertDated(Path decision, List<String> lines) {
        for (int i = 0; i < lines.size(); i++) {
            if (lines.get(i).matches("\\|[-|]+\\|")) {
                assertThat(lines.get(Math.max(i - 3, 0))).as("%s, above the table of '%s'", decision, lines.get(i - 1))
                        .matches("\\*Recorded \\d{4}-\\d\\d-\\d\\d.*, last at commit `[0-9a-f]{8}`\\.\\*");
            }
        }
    }

    @Test
    void unknownMarkers_areRejected() {
        assertThatThrownBy(() -> new MarkdownTables(ResultsArbitraries.of(1)).of("no such")).isInstanceOf(IllegalArgumentException.class);
        BenchResults any = ResultsArbitraries.of(1);
        assertThatThrownBy(() -> new ModernTables(any).of("no such")).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new IndirectTables(any).of("no such")).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new ReportStatements(any, any, any).of("no such")).isInstanceOf(IllegalArgumentException.class);
    }
}
