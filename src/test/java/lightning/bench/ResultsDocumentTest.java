package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import lightning.bench.report.Tables;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * docs/results.md says what the kept run says: its tables are made from that run, and its sentences measure nothing that no
 * table shows. {@code -Dlightning.write=true} writes the tables anew.
 */
class ResultsDocumentTest {
    private static final Path DOCUMENT = Path.of("docs", "results.md");
    private static final Path KEPT = Path.of("benchmarks", "results", "results.json");
    private static final Path KEPT_EFFECTS = Path.of("benchmarks", "results", "effects.json");
    /** Scenes of today's lights and surfaces, at a smaller size. */
    private static final Path KEPT_SURFACES = Path.of("benchmarks", "results", "surfaces.json");
    /** Ends the names of tables that are made from it. */
    private static final String SMALL = ", small";
    /** Kept once {@code benchmarks/run} has measured it. */
    private static final Path KEPT_COLD = Path.of("benchmarks", "results", "cold.json");
    private static final Path KEPT_EDITING = Path.of("benchmarks", "results", "editing.json");
    private static final Path KEPT_MESHES = Path.of("benchmarks", "results", "meshes.json");
    private static final Pattern TABLE = Pattern.compile("(<!-- table: (.+?) -->\n)(.*?)(<!-- end -->)", Pattern.DOTALL);
    /** A measured figure: one with a fraction, or of percent or milliseconds. */
    private static final Pattern MEASURED = Pattern.compile("(?<![\\w.×§])(\\d+\\.\\d+(?:e-?\\d+)?|\\d+(?= %| ms))");
    private static final Pattern NUMBER = Pattern.compile("\\d+(?:\\.\\d+)?(?:e-?\\d+)?");

    static List<String> names() {
        return Tables.names();
    }

    @Test
    void everyTable_isMadeFromTheKeptRun() throws IOException {
        Tables tables = new Tables(ResultsFile.readJson(KEPT));
        Tables every = new Tables(together(ResultsFile.readJson(KEPT), ResultsFile.readJson(KEPT_EFFECTS)));
        Tables cold = Files.exists(KEPT_COLD) ? new Tables(ResultsFile.readJson(KEPT_COLD)) : tables;
        Tables editing = new Tables(ResultsFile.readJson(KEPT_EDITING));
        Tables meshes = new Tables(ResultsFile.readJson(KEPT_MESHES));
        Tables small = new Tables(ResultsFile.readJson(KEPT_SURFACES));
        String text = Files.readString(DOCUMENT);
        String wanted = TABLE.matcher(text).replaceAll(m -> {
            String name = m.group(2).replace(SMALL, "");
            Tables made = m.group(2).endsWith(SMALL) ? small : switch (name) {
                case "scenes", "effects in use", "effects absent" -> every;
                case "cold" -> cold;
                case "editing" -> editing;
                case "meshes", "rays" -> meshes;
                default -> tables;
            };
            return Matcher.quoteReplacement(m.group(1) + made.of(name) + m.group(4));
        });
        if (Boolean.getBoolean("lightning.write")) {
            Files.writeString(DOCUMENT, wanted);
        }
        assertThat(Files.readString(DOCUMENT)).isEqualTo(wanted);
        assertThat(TABLE.matcher(text).results().map(m -> m.group(2))).contains("savings", "ladder", "effects in use", "effects absent",
                "effects in use, small", "cold");
    }

    private static Results together(Results all, Results effectsAlone) {
        List<SceneResult> scenes = new ArrayList<>(all.scenes());
        scenes.addAll(effectsAlone.scenes());
        return new Results(all.run(), scenes, all.drift(), all.growth(), all.editing(), all.meshes(), all.problems());
    }

    @Test
    void everyMeasuredFigureOfASentence_isInATable() throws IOException {
        String text = Files.readString(DOCUMENT);
        String tables = TABLE.matcher(text).results().map(m -> m.group(3)).collect(Collectors.joining());
        Set<String> shown = NUMBER.matcher(tables).results().map(m -> m.group()).collect(Collectors.toSet());
        List<String> unknown = new ArrayList<>();
        MEASURED.matcher(TABLE.matcher(text).replaceAll("")).results().map(m -> m.group(1)).filter(n -> !shown.contains(n))
                .forEach(unknown::add);
        assertThat(unknown).as("figures in sentences that no table of the document shows").isEmpty();
    }

    @ParameterizedTest
    @MethodSource("names")
    void everyTable_canBeMadeOfAnyRun(String name) {
        for (long seed = 0; seed < 20; seed++) {
            assertThat(new Tables(ResultsArbitraries.of(seed)).of(name)).startsWith("| ").endsWith("|\n");
        }
    }
}
