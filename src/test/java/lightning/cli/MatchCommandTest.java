package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import lightning.format.image.ImageFile;
import lightning.format.jen.JenReader;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Scene;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class MatchCommandTest {
    @TempDir
    private Path folder;
    private Path scene;
    private Path reference;

    @BeforeEach
    void renderReference() throws IOException {
        scene = CliResult.scene(folder);
        reference = folder.resolve("look.pfm");
        CliResult.run("relight", scene, "-o", reference, "--no-savings", "--set", "lamp.intensity=3", "--set", "sun.intensity=0.1")
                .assertSuccess();
    }

    @Test
    void matchedScene_hasTheIntensitiesOfTheReference() throws Exception {
        Path matched = folder.resolve("matched.jen");
        CliResult result = CliResult.run("match", scene, "--reference", reference, "-o", matched).assertSuccess();
        assertThat(result.out()).contains("lamp", "intensity 1 to 3", "+1.58 stops", "% before");
        Scene found = JenReader.read(matched).scene();
        assertThat(found.light("lamp").orElseThrow().intensity()).isCloseTo(3, within(3e-3));
        assertThat(found.light("sun").orElseThrow().intensity()).isCloseTo(0.1, within(1e-4));
        assertThat(found.light("stage").orElseThrow().intensity()).isCloseTo(1, within(1e-3));
        assertThat(Files.readString(matched)).contains("# what lights it");
    }

    @Test
    void withoutOutput_nothingIsWritten() throws Exception {
        String before = Files.readString(scene);
        CliResult.run("match", scene, "--reference", reference).assertSuccess();
        assertThat(Files.readString(scene)).isEqualTo(before);
        try (var files = Files.list(folder)) {
            assertThat(files).containsExactlyInAnyOrder(scene, reference);
        }
    }

    @Test
    void json_hasFactorsAndErrors() throws Exception {
        CliResult result = CliResult.run("match", scene, "--reference", reference, "--lights", "lamp,sun", "--json").assertSuccess();
        JsonNode report = new JsonMapper().readTree(result.out()).get("result");
        assertThat(report.at("/lights/0/light").asString()).isEqualTo("lamp");
        assertThat(report.at("/lights/0/factors/1").asDouble()).isCloseTo(3, within(3e-3));
        assertThat(report.get("lights")).hasSize(2);
        assertThat(report.get("error_after").asDouble()).isLessThan(1e-5);
        assertThat(report.get("error_before").asDouble()).isGreaterThan(0.01);
        assertThat(report.has("output")).isFalse();
    }

    @Test
    void referenceOfAnotherSize_isScaled() {
        Path large = folder.resolve("large.png");
        CliResult.run("render", scene, "-o", large, "--size", "96x64").assertSuccess();
        assertThat(CliResult.run("match", scene, "--reference", large).assertSuccess().out()).contains("difference from the reference");
    }

    @Test
    void referenceOfAnotherShape_isRejected() {
        Path square = folder.resolve("square.png");
        CliResult.run("render", scene, "-o", square, "--size", "32x32").assertSuccess();
        CliResult.run("match", scene, "--reference", square).assertRejected("square.png", "48 x 32", "found 32 x 32");
    }

    @Test
    void unknownLight_isRejected() {
        CliResult.run("match", scene, "--reference", reference, "--lights", "moon").assertRejected("there is no light", "moon");
    }

    @Test
    void regionOutsideTheReference_isRejected() {
        CliResult.run("match", scene, "--reference", reference, "--region", "100,100,5,5")
                .assertRejected("no pixel of the reference counts");
    }

    /** A picture that Lightning wrote shows what its view made of the light. */
    @ParameterizedTest
    @ValueSource(strings = {"srgb", "filmic", "aces", "aces2", "agx"})
    void codesOfAnyView_giveTheLightBack(String view) throws Exception {
        Files.writeString(scene, CliResult.SCENE.replace("depth 2", "depth 2  exposure -1  view " + view));
        Path codes = folder.resolve("look.png");
        CliResult.run("relight", scene, "-o", codes, "--bits=16", "--no-savings", "--set", "lamp.intensity=2").assertSuccess();
        CliResult result = CliResult.run("match", scene, "--reference", codes, "--json").assertSuccess();
        JsonNode report = new JsonMapper().readTree(result.out()).get("result");
        assertThat(report.at("/lights/0/factors/0").asDouble()).isCloseTo(2, within(0.02));
        assertThat(report.at("/lights/1/factors/0").asDouble()).isCloseTo(1, within(0.02));
    }

    /** Keyframes override what the match sets. */
    /** The reference was made for another view than the scene's. */
    @Test
    void view_isThatOfTheReference() throws Exception {
        Path codes = folder.resolve("agx.png");
        CliResult.run("relight", scene, "-o", codes, "--bits=16", "--no-savings", "--set", "lamp.intensity=2", "--view", "agx")
                .assertSuccess();
        JsonNode result = new JsonMapper().readTree(CliResult.run("match", scene, "--reference", codes, "--view", "agx", "--json")
                .assertSuccess().out()).get("result");
        assertThat(result.get("error_after").doubleValue()).isLessThan(0.01);
        JsonNode other = new JsonMapper().readTree(CliResult.run("match", scene, "--reference", codes, "--json").assertSuccess().out())
                .get("result");
        assertThat(other.get("error_after").doubleValue()).isGreaterThan(0.05);
    }

    @Test
    void changedPlaces_arePrinted() throws Exception {
        Path moved = folder.resolve("moved.exr");
        CliResult.run("relight", scene, "-o", moved, "--no-savings", "--set", "lamp.at=-2.2 3.6 2.8").assertSuccess();
        CliResult result = CliResult.run("match", scene, "--reference", moved, "--lights", "lamp", "--change", "positions").assertSuccess();
        assertThat(result.out()).containsPattern("lamp +at -3 4 3 to ");
    }

    @Test
    void unknownChange_isRejected() {
        CliResult.run("match", scene, "--reference", reference, "--change", "sizes").assertRejected("sizes", "POSITIONS");
    }

    @Test
    void keyedLight_getsANote() throws IOException {
        Files.writeString(scene, CliResult.SCENE + "shot { frames 1 10  light lamp { intensity { 1 1  10 2 } } }\n");
        assertThat(CliResult.run("match", scene, "--reference", reference).assertSuccess().err())
                .contains("lamp has keyframes of its intensity");
    }

    @Test
    void referenceAsOutput_isRejected() throws IOException {
        String before = Files.readString(scene);
        CliResult.run("match", scene, "--reference", reference, "-o", reference).assertRejected("look.pfm");
        assertThat(Files.readString(scene)).isEqualTo(before);
    }

    /** Returns the reference with one value replaced, or all. */
    private Path damaged(float value, boolean all) throws IOException {
        float[] rgb = ImageFile.read(reference).toScanlines();
        Arrays.fill(rgb, 0, all ? rgb.length : 1, value);
        Film film = ImageFile.read(reference);
        Path file = folder.resolve("damaged.pfm");
        ImageFile.write(file, Film.ofScanlines(film.width(), film.height(), rgb), ViewTransform.DEFAULT);
        return file;
    }

    @Test
    void pixelThatIsNoNumber_doesNotCount() throws Exception {
        CliResult result = CliResult.run("match", scene, "--reference", damaged(Float.NaN, false), "--json").assertSuccess();
        JsonNode report = new JsonMapper().readTree(result.out()).get("result");
        assertThat(report.get("invalid_pixels").asInt()).isEqualTo(1);
        assertThat(report.at("/lights/0/factors/1").asDouble()).isCloseTo(3, within(3e-3));
        assertThat(result.out()).contains("damaged.pfm: 1 pixel is infinite or not a number, and did not count");
    }

    @ParameterizedTest
    @ValueSource(floats = {Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY})
    void referenceWithoutNumbers_isRefused(float value) throws Exception {
        CliResult result = CliResult.run("match", scene, "--reference", damaged(value, true));
        assertThat(result.exit()).isEqualTo(2);
        assertThat(result.err()).contains("damaged.pfm: expected an image of numbers");
    }
}
