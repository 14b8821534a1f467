package lightning.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.bench.result.BenchResults;
import lightning.bench.result.EffectResult;
import lightning.bench.result.IndirectAccuracy;
import lightning.bench.result.IndirectResults;
import lightning.bench.result.ModernPicture;
import lightning.bench.result.ModernSampling;
import lightning.bench.result.ModernScene;
import lightning.bench.result.ResultsArbitraries;
import lightning.bench.result.SampleResults;
import lightning.bench.result.SceneResult;
import lightning.render.measure.AccuracySetting;
import lightning.render.measure.IndirectError;
import lightning.sample.TryFolder;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Reports as files; {@link ReportPageTest} opens them. */
class HtmlReportTest {
    private static final Pattern DATA = Pattern.compile("<script type=\"application/json\" id=\"data\">(.*?)</script>", Pattern.DOTALL);

    @TempDir
    private Path folder;

    private static String write(BenchResults results, Path folder) throws IOException {
        HtmlReport.write(results, folder);
        return Files.readString(folder.resolve(HtmlReport.FILE));
    }

    private static JsonNode data(String page) {
        Matcher data = DATA.matcher(page);
        assertThat(data.find()).isTrue();
        return new JsonMapper().readTree(data.group(1));
    }

    @Property(tries = 15)
    void anyResults_giveSelfContainedPage(@ForAll long seed) throws IOException {
        BenchResults results = ResultsArbitraries.of(seed);
        try (TryFolder files = new TryFolder()) {
            String page = write(results, files.path());
            assertThat(data(page).get("results").get("scenes")).hasSize(results.scenes().size());
            assertThat(data(page).at("/results/run/commit").asString()).isEqualTo(results.run().commit());
            String program = DATA.matcher(page).replaceAll("");
            assertThat(program).contains("default-src 'none'").doesNotContain("{{", " src=", "@import", "https:")
                    .doesNotContainPattern("http:(?!//www\\.w3\\.org/)").doesNotContainPattern("url\\((?!#)");
        }
    }

    @Test
    void namesWithMarkup_cannotEndTheData() throws IOException {
        String name = "</script><script>alert('\"&')</script><!--{{script}}";
        String page = write(new BenchResults(SampleResults.RUN,
                List.of(new SceneResult(name, 300, 200, 3, 10, 3, null, null, List.of(), List.of(), null, null)), List.of(), List.of(),
                List.of(), List.of(), List.of(), List.of()), folder);

        assertThat(data(page).at("/results/scenes/0/scene").asString()).isEqualTo(name);
        Matcher data = DATA.matcher(page);
        assertThat(data.find()).isTrue();
        assertThat(data.group(1)).doesNotContain("<");
        assertThat(Pattern.compile("<script").matcher(page).results()).hasSize(2);
    }

    @Test
    void numbersWithoutAWord_areNoTexts() throws IOException {
        var effect = new EffectResult("NaN", true, List.of("Infinity"), Double.NaN, Double.NEGATIVE_INFINITY, 1, 1, 1, 1);
        JsonNode shown = data(write(new BenchResults(SampleResults.RUN,
                List.of(new SceneResult("NaN", 1, 1, 1, 1, 1, null, null, List.of(), List.of(effect), null, null)), List.of(), List.of(),
                List.of(), List.of(), List.of(), List.of()), folder)).at("/results/scenes/0/effects/0");

        assertThat(shown.get("effect").asString()).isEqualTo("NaN");
        assertThat(shown.at("/firstMs/double").asString()).isEqualTo("NaN");
        assertThat(shown.at("/updateMs/double").asString()).isEqualTo("-Infinity");
    }

    @Test
    void data_haveDerivedNumbers() throws IOException {
        var time = SampleResults.samples(10, 10, 10);
        var hall = new IndirectAccuracy("hall", 4, 3, 2, 16, 4, time,
                List.of(new IndirectAccuracy.Point(3, 5, 7, time, 1, 1, new IndirectError(0.1, 0.1, 0.1, 0.1, 0.1))));
        var effects = List.of(new EffectResult("fog", true, List.of(), 5, 1, 2, 2, 1, 1));
        JsonNode data = data(write(new BenchResults(SampleResults.RUN,
                List.of(new SceneResult("bird", 1, 1, 1, 1, 1, null, null, List.of(), effects, null, null)), List.of(), List.of(),
                List.of(),
                List.of(),
                List.of(new ModernScene("hall", List.of(new ModernPicture(ModernSampling.EDGES, 1, 1, null, List.of(), 1, 1, null)),
                        List.of(),
                        List.of())),
                new IndirectResults(List.of(hall), List.of(), List.of(), List.of(), List.of(), List.of()), List.of()), folder));

        assertThat(data.at("/results/scenes/0/effects/0/certainFirstMs").asDouble()).isEqualTo(5);
        assertThat(data.at("/results/scenes/0/effects/0/certainUpdateMs/double").asString()).isEqualTo("NaN");
        assertThat(data.at("/results/modern/0/pictures/0/sampling").asString()).isEqualTo(ModernSampling.EDGES.label());
        assertThat(data.at("/results/indirect/accuracy/0/points/0/usesDefault").asBoolean()).isFalse();
        assertThat(data.at("/results/indirect/accuracy/0/grid")).hasSize(hall.grid().size());
        assertThat(data.get("settings")).hasSize(AccuracySetting.values().length);
        assertThat(data.get("usual").asString()).isEqualTo(AccuracySetting.DEFAULT.name());
    }

    @Test
    void withoutScripts_aSentenceSaysWhy() throws IOException {
        assertThat(write(ResultsArbitraries.of(1), folder)).containsPattern("<noscript><p [^>]*>[^<]*JavaScript[^<]*</p></noscript>");
    }
}
