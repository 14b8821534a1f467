package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.RecordComponent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import lightning.cli.report.BenchReport;
import lightning.cli.report.CheckReport;
import lightning.cli.report.CompareReport;
import lightning.cli.report.ConversionReport;
import lightning.cli.report.EffectsReport;
import lightning.cli.report.ErrorReport;
import lightning.cli.report.JsonOutput;
import lightning.cli.report.OcioReport;
import lightning.cli.report.RaysReport;
import lightning.cli.report.RelightReport;
import lightning.cli.report.RenderReport;
import lightning.cli.report.ReviewReport;
import lightning.cli.report.ShotLightsReport;
import lightning.cli.report.ShotRelightReport;
import lightning.cli.report.ShotRenderReport;
import lightning.cli.report.TourReport;
import lightning.format.json.ExplainReport;
import lightning.format.json.MatchReport;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Output with {@code --json} and {@code --quiet}. */
class JsonReportTest {
    private static final JsonMapper MAPPER = JsonMapper.builder().build();

    @TempDir
    Path folder;
    private Path scene;

    @BeforeEach
    void writeScene() throws IOException {
        scene = CliResult.scene(folder);
    }

    /** Runs a command with {@code --json} and returns its object. */
    private JsonNode run(int exit, Object... arguments) {
        CliResult result = CliResult.run(Stream.concat(Stream.of(arguments), Stream.of("--json")).toArray());
        assertThat(result.exit()).as(result.err()).isEqualTo(exit);
        JsonNode json = MAPPER.readTree(result.out());
        assertThat(json.get("exit_code").intValue()).isEqualTo(exit);
        assertThat(json.get("text")).isNull();
        return json;
    }

    @Test
    void wrongArguments_haveTheNameOfTheirCommand() {
        assertThat(run(2, "explain", scene, "--pixel", "1,1").get("command").asString()).isEqualTo("explain");
        assertThat(run(2, "shot", "render", "--siez=1x1").get("command").asString()).isEqualTo("shot render");
        assertThat(run(2, "--quiet", "check", "--no").get("command").asString()).isEqualTo("check");
        assertThat(run(2, "rendr").get("command").asString()).isEqualTo("lightning");
    }

    private Path file(String name) {
        return folder.resolve(name);
    }

    @Test
    void check_countsObjectsAndLights_withRemarksAsNotes() throws IOException {
        Files.writeString(scene, CliResult.SCENE + "light far directional { at 1 2 3 }\n");
        JsonNode json = run(0, "check", scene);
        assertThat(json.get("command").stringValue()).isEqualTo("check");
        assertThat(json.at("/result/objects_by_type/sphere").intValue()).isEqualTo(1);
        assertThat(json.at("/result/lights").intValue()).isEqualTo(4);
        assertThat(json.at("/result/width_pixels").intValue()).isEqualTo(48);
        assertThat(json.at("/notes/0").stringValue()).endsWith("far.at has no effect: a directional light has no position");
    }

    @Test
    void brokenScene_hasErrorsWithPlaces() throws IOException {
        Files.writeString(scene, "jen 1\nsphere ball { at x }\n");
        JsonNode json = run(2, "check", scene);
        assertThat(json.get("result")).isNull();
        assertThat(json.at("/errors/0/file").stringValue()).isEqualTo(scene.toString());
        assertThat(json.at("/errors/0/line").intValue()).isEqualTo(2);
        assertThat(json.at("/errors/0/column").intValue()).isEqualTo(15);
    }

    @ParameterizedTest
    @ValueSource(strings = {"rendr", "render --siez 20x20", "render", "shot rendr"})
    void badUsage_isAnErrorInTheObject(String line) {
        JsonNode json = run(2, (Object[]) line.split(" "));
        assertThat(json.at("/errors/0/message").stringValue()).startsWith("lightning");
        assertThat(json.get("errors")).as("the hint is no error").hasSize(1);
    }

    @Test
    void renderAndCompare_haveNumbers() {
        JsonNode render = run(0, "render", scene, "-o", file("a.png")).get("result");
        assertThat(render.get("milliseconds").doubleValue()).isPositive();
        assertThat(render.at("/rays/eye").longValue()).isEqualTo(48 * 32);
        assertThat(render.get("clipped_pixels").isNumber()).isTrue();
        run(0, "render", scene, "-o", file("b.pfm"), "--traditional");
        run(0, "relight", scene, "-o", file("c.pfm"), "--set", "lamp.intensity=2", "--no-savings");
        JsonNode equal = run(0, "compare", file("b.pfm"), file("b.pfm")).get("result");
        assertThat(equal.get("equal").booleanValue()).isTrue();
        assertThat(equal.get("psnr_db").isNull()).isTrue();
        JsonNode other = run(1, "compare", file("b.pfm"), file("c.pfm")).get("result");
        assertThat(other.get("max_difference_ulp").longValue()).isPositive();
        assertThat(other.get("psnr_db").doubleValue()).isPositive();
    }

    @Test
    void compareOfEightBits_hasLevelsInsteadOfUlp() {
        run(0, "render", scene, "-o", file("a.png"));
        run(0, "render", scene, "-o", file("b.png"), "--exposure", "1");
        JsonNode json = run(1, "compare", file("a.png"), file("b.png")).get("result");
        assertThat(json.get("max_difference_ulp")).isNull();
        assertThat(json.get("max_difference_levels").intValue()).isBetween(1, 255);
        assertThat(CliResult.run("compare", file("a.png"), file("b.png")).out()).contains("of 255 levels").doesNotContain("ulp");
    }

    @Test
    void relight_hasOneStepPerGroup() {
        JsonNode json = run(0, "relight", scene, "-o", file("%d.png"), "--set", "lamp.intensity=2", "--then", "--delete", "sun", "--verify",
                "--no-savings").get("result");
        assertThat(json.get("steps").size()).isEqualTo(2);
        assertThat(json.at("/steps/1/image").stringValue()).isEqualTo(file("2.png").toString());
        assertThat(json.at("/steps/0/verified/passed").booleanValue()).isTrue();
        assertThat(json.at("/steps/0/error_bound_linear").doubleValue()).isZero();
        assertThat(json.at("/steps/0/full_trace_milliseconds").isMissingNode()).isTrue();
    }

    @Test
    void explain_hasSharesOfTheLights_thatAddUp() {
        JsonNode center = run(0, "explain", scene, "24,20").at("/result/center");
        double sum = center.at("/ambient/0").doubleValue() + center.at("/glow/0").doubleValue()
                + (center.has("reflected") ? center.at("/reflected/adds/0").doubleValue() : 0);
        for (JsonNode light : center.get("lights")) {
            sum += light.at("/adds/0").doubleValue();
        }
        // Eight terms of floats near 1, each rounded to half a unit in the last place, and once more for each sum.
        assertThat(sum).isCloseTo(center.at("/color/0").doubleValue(), Offset.offset(16 * 0x1p-24));
    }

    @Test
    void effectsAndTour_haveRows() {
        JsonNode effects = run(0, "effects", scene, "--repetitions", "1").get("result");
        assertThat(effects.get("effects").size()).isGreaterThan(5);
        assertThat(effects.get("columns").size()).isGreaterThan(3);
        JsonNode tour = run(0, "tour", scene, "-o", file("tour"), "--size", "24x16", "--repetitions", "1").get("result");
        assertThat(tour.get("edits").size()).isGreaterThan(5);
        assertThat(tour.at("/edits/0/equal").booleanValue()).isTrue();
    }

    @Test
    void shots_haveFramesAndGroups() {
        String dusk = "scenes/dusk.jen";
        JsonNode render = run(0, "shot", "render", dusk, "-o", file("frames"), "--frames", "1-2", "--size", "24x16").get("result");
        assertThat(render.get("frames").size()).isEqualTo(2);
        assertThat(render.at("/frames/1/frame").intValue()).isEqualTo(2);
        JsonNode relight = run(0, "shot", "relight", dusk, "-o", file("relit"), "--frames", "1-2", "--size", "24x16", "--set",
                "world.ambience=0.5", "--no-savings").get("result");
        assertThat(relight.at("/groups/0/folder").stringValue()).isEqualTo(file("relit").toString());
    }

    @Test
    void conversions_listLosses() {
        JsonNode pov = run(0, "export", scene, "-o", file("a.pov")).get("result");
        assertThat(pov.get("losses").isObject()).isTrue();
        assertThat(run(0, "export-lights", scene, "-o", file("a.json")).at("/result/lights").intValue()).isEqualTo(3);
        assertThat(run(0, "import", "src/main/release/bolt.ply", "-o", file("bolt.jen")).at("/result/objects").intValue()).isEqualTo(1);
    }

    @Test
    void commandWithoutRecord_hasItsLines() {
        CliResult result = CliResult.run("node", "--make-certificate", file("a.p12"), "--json").assertSuccess();
        assertThat(MAPPER.readTree(result.out()).at("/text/0").stringValue()).contains("created");
    }

    @Test
    void quiet_printsOnlyErrors() {
        CliResult done = CliResult.run("check", scene, "--quiet").assertSuccess();
        assertThat(done.out() + done.err()).isEmpty();
        assertThat(CliResult.run("check", file("missing.jen"), "-q").err()).contains("file not found");
    }

    @Test
    void everyField_isDocumented() throws IOException {
        String page = Files.readString(Path.of("docs/json.md"));
        List<Class<?>> records = new ArrayList<>(List.of(BenchReport.class, CheckReport.class, CompareReport.class, ConversionReport.class,
                EffectsReport.class, ErrorReport.class, ExplainReport.class, JsonOutput.class, MatchReport.class, OcioReport.class,
                RaysReport.class,
                RelightReport.class,
                RenderReport.class, ReviewReport.class, ShotLightsReport.class, ShotRelightReport.class, ShotRenderReport.class,
                TourReport.class));
        for (int i = 0; i < records.size(); i++) {
            Stream.of(records.get(i).getDeclaredClasses()).filter(Class::isRecord).forEach(records::add);
            for (RecordComponent field : records.get(i).getRecordComponents()) {
                assertThat(page).contains("`" + field.getName().replaceAll("([A-Z])", "_$1").toLowerCase(Locale.ROOT) + "`");
            }
        }
        try (Stream<Path> files = Files.list(Path.of("src/main/java/lightning/cli/report"))) {
            assertThat(files).hasSize((int) records.stream()
                    .filter(type -> type.getEnclosingClass() == null && type.getPackage() == JsonOutput.class.getPackage()).count() + 1);
        }
    }
}
