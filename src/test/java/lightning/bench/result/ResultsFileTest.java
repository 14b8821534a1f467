package lightning.bench.result;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.render.measure.AccuracySetting;
import lightning.sample.TryFolder;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.lifecycle.AfterContainer;
import net.jqwik.api.lifecycle.BeforeContainer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ResultsFileTest {
    private static TryFolder shared;

    @TempDir
    Path folder;

    @BeforeContainer
    static void makeFolder() throws IOException {
        shared = new TryFolder();
    }

    @AfterContainer
    static void removeFolder() throws IOException {
        shared.close();
    }

    @Property(tries = 100)
    void json_readsBackAsWritten(@ForAll long seed) throws IOException {
        BenchResults results = ResultsArbitraries.of(seed);
        Path file = shared.file("results.json");
        ResultsFile.writeJson(file, results);
        assertThat(ResultsFile.readJson(file)).isEqualTo(results);
    }

    private static int processes(ColdStart cold) {
        if (cold == null) {
            return 0;
        }
        int ours = cold.processor() == null ? 1 : 2;
        return cold.rival() == null ? ours : ours + (cold.rival().processor() == null ? 1 : 2);
    }

    private static int rows(ModernScene scene) {
        return scene.pictures().stream()
                .mapToInt(p -> (p.firstPass() == null ? 0 : 2) + p.edits().size() + processes(p.cold())).sum()
                + scene.curves().stream().mapToInt(curve -> curve.points().size()).sum();
    }

    private static int rows(IndirectResults indirect) {
        return indirect.accuracy().stream().mapToInt(scene -> scene.points().size()).sum()
                + indirect.reflections().stream().mapToInt(scene -> scene.points().size()).sum()
                + indirect.softShadows().stream().mapToInt(scene -> scene.points().size()).sum()
                + indirect.costs().stream().mapToInt(cost -> 3 + 2 * cost.edits().size()).sum()
                + indirect.growth().stream().mapToInt(growth -> 4 * growth.points().size()).sum() + 2 * indirect.absence().size();
    }

    private static int rows(MeshPoint mesh) {
        return (mesh.rival() == null ? 1 : 2) + mesh.rays().stream().mapToInt(pace -> pace.rival() == null ? 1 : 2).sum();
    }

    @Property(tries = 30)
    void csv_hasRowPerMeasurementWithEveryColumn(@ForAll long seed) {
        BenchResults results = ResultsArbitraries.of(seed);
        int rows = results.scenes().stream()
                .mapToInt(s -> (s.firstPass() == null ? 0 : 2) + (s.peer() == null ? 0 : 1) + processes(s.cold()) + s.effects().size()
                        + s.edits().stream().flatMap(e -> e.values().stream()).mapToInt(v -> v.rungs().size()).sum())
                .sum()
                + results.growth().stream().flatMap(g -> g.points().stream()).mapToInt(p -> 1 + p.edits().size()).sum()
                + 5 * results.editing().size() + results.meshes().stream().mapToInt(ResultsFileTest::rows).sum()
                + results.modern().stream().mapToInt(ResultsFileTest::rows).sum() + rows(results.indirect())
                + results.drift().stream().mapToInt(d -> d.points().size()).sum();
        assertThat(CsvRow.of(results)).hasSize(rows);
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`',
            value = {"bird, bird", "=1+1, '=1+1", "+a, '+a", "-2+3, '-2+3", "@sum, '@sum", "-0.5, -0.5", "+3, +3", "'a, ''a",
                "＝1, '＝1", "`\t=1`, `'\t=1`"})
    void csvCell_isNeverAFormula(String text, String cell) {
        assertThat(CsvRow.cell(text)).isEqualTo(cell);
    }

    @Test
    void csvOfSceneNamedLikeFormula_storesText() throws IOException {
        SceneResult formula =
                new SceneResult("=cmd|'/c calc'!A1", 300, 200, 3, 10, 3, null, null, SampleResults.scene(5).edits(), List.of(), null, null);
        BenchResults results =
                new BenchResults(SampleResults.RUN, List.of(formula), List.of(), List.of(), List.of(), List.of(), List.of(), List.of());
        Path csv = folder.resolve("results.csv");
        ResultsFile.writeCsv(csv, results);
        assertThat(Files.readString(csv)).contains("edit,\"'=cmd|'/c calc'!A1\",300,");
        Path json = folder.resolve("results.json");
        ResultsFile.writeJson(json, results);
        assertThat(ResultsFile.readJson(json)).isEqualTo(results);
    }

    @Test
    void csv_hasHeaderAndQuotesCommas() throws IOException {
        Path file = folder.resolve("results.csv");
        ResultsFile.writeCsv(file,
                new BenchResults(SampleResults.RUN, List.of(SampleResults.scene(5)), List.of(), List.of(), List.of(), List.of(), List.of(),
                        List.of()));
        List<String> lines = Files.readAllLines(file);
        assertThat(lines.getFirst()).startsWith("kind,scene,width,height,edit,value,level,n,medianMs,lowerQuartileMs,upperQuartileMs,");
        assertThat(lines).hasSize(3);
        assertThat(lines.get(1))
                .startsWith("edit,bird,300,200,color,\"sun: color 1 1 1 → 1 0 0, on yes → no\",exact,3,5.0,4.0,6.0,75.0,90.0,98.0,"
                        + "\"sun: weight\",");
    }

    @Test
    void json_hasExpectedKeys() throws IOException {
        Path file = folder.resolve("results.json");
        ResultsFile.writeJson(file,
                new BenchResults(SampleResults.RUN, List.of(SampleResults.scene(5)), List.of(), List.of(), List.of(), List.of(), List.of(),
                        List.of()));
        assertThat(Files.readString(file))
                .contains("\"scene\" : \"bird\"", "\"level\" : \"" + AccuracySetting.EXACT + "\"", "\"median\" : 5.0",
                        "\"samples\" : [ 5.0, 3.0, 7.0 ]")
                .doesNotContain("\"empty\"");
    }

    @Test
    void otherFiles_areRejectedWithLocation() throws IOException {
        Path file = folder.resolve("old.json");
        Files.writeString(file, "{\n  \"run\": 5 oops }");
        assertThatThrownBy(() -> ResultsFile.readJson(file)).isInstanceOf(IOException.class)
                .hasMessageStartingWith(file + ":2:").hasMessageContaining("expected a results file of 'lightning bench'");
        Files.writeString(file, "{\"scenes\": []}");
        assertThatThrownBy(() -> ResultsFile.readJson(file)).isInstanceOf(IOException.class).hasMessageContaining("run");
        Files.writeString(file, "");
        assertThatThrownBy(() -> ResultsFile.readJson(file)).isInstanceOf(IOException.class)
                .hasMessageContaining("expected a results file");
        assertThatThrownBy(() -> ResultsFile.readJson(folder.resolve("none.json"))).isInstanceOf(IOException.class);
    }
}
