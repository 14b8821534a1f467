package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import lightning.format.jen.JenReader;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class ShotLightsCommandTest {
    /** A lamp that lights, one that does so in the last frame only, two that are too weak together, and one behind the wall. */
    private static final String SCENE = """
            jen 1
            picture { size 12 8 }
            camera { from 0 1 4  to 0 0 0 }
            sphere ball { }
            light key point { at 1 2 3  intensity 1 }
            light late point { at -1 2 3  intensity 1 }
            light weak point { at 1 2 3  intensity 0.001 }
            light weaker point { at 1 2 3  intensity 0.0005 }
            light inside point { at 0 0 0  intensity 1 }
            shot { frames 1 3  light late { on { 1 no  3 yes } } }
            """;

    @TempDir
    private Path folder;
    private Path scene;

    @BeforeEach
    void write() throws IOException {
        scene = Files.writeString(folder.resolve("a.jen"), SCENE);
    }

    private JsonNode result(Object... arguments) {
        return new JsonMapper().readTree(CliResult.run(arguments).assertSuccess().out()).get("result");
    }

    @Test
    void lights_areSortedByWhatTheyChange() {
        JsonNode lights = result("shot", "lights", scene, "--json").get("lights");
        assertThat(lights.get(0).get("light").asString()).isEqualTo("inside");
        assertThat(lights.get(0).get("max_difference_linear").asDouble()).isZero();
        assertThat(lights.get(0).has("frame")).isFalse();
        assertThat(lights.get(1).get("light").asString()).isEqualTo("weaker");
        assertThat(lights.get(2).get("light").asString()).isEqualTo("weak");
    }

    @Test
    void lightOfOneFrame_isNeeded() {
        JsonNode report = result("shot", "lights", scene, "--json");
        for (JsonNode light : report.get("lights")) {
            if (light.get("light").asString().equals("late")) {
                assertThat(light.get("frame").asInt()).isEqualTo(3);
                assertThat(light.get("max_steps").asInt()).isGreaterThan(10);
            }
        }
        JsonNode early = result("shot", "lights", scene, "--frames", "1-2", "--json");
        assertThat(early.get("needless").toString()).contains("late");
        assertThat(report.get("needless").toString()).doesNotContain("late");
    }

    @Test
    void needlessLights_areLeftOutAndMeasuredTogether() throws Exception {
        Path output = folder.resolve("less.jen");
        JsonNode report = result("shot", "lights", scene, "--steps", "5", "-o", output, "--json");
        assertThat(report.get("needless").toString()).contains("weak", "weaker", "inside").doesNotContain("key");
        assertThat(JenReader.read(output).scene().lights()).extracting("name").containsExactly("key", "late");
        CliResult.run("shot", "render", scene, "-o", folder.resolve("with")).assertSuccess();
        CliResult.run("shot", "render", output, "-o", folder.resolve("without")).assertSuccess();
        int largest = 0;
        for (int frame = 1; frame <= 3; frame++) {
            largest = Math.max(largest,
                    largestStep(folder.resolve("with/a-000" + frame + ".png"), folder.resolve("without/less-000" + frame + ".png")));
        }
        assertThat(report.get("together_steps").asInt()).isEqualTo(largest);
    }

    private static int largestStep(Path a, Path b) throws IOException {
        BufferedImage with = ImageIO.read(a.toFile());
        BufferedImage without = ImageIO.read(b.toFile());
        int largest = 0;
        for (int y = 0; y < with.getHeight(); y++) {
            for (int x = 0; x < with.getWidth(); x++) {
                for (int shift = 0; shift < 24; shift += 8) {
                    largest = Math.max(largest, Math.abs((with.getRGB(x, y) >> shift & 0xff) - (without.getRGB(x, y) >> shift & 0xff)));
                }
            }
        }
        return largest;
    }

    @Test
    void sequence_isMeasuredInAllShots() throws IOException {
        Files.writeString(folder.resolve("rig.jen"),
                "jen 1\nlight key point { at 1 2 3 }\nlight low point { at -1 2 3  intensity 0.0001 }\n");
        Path sequence = Files.writeString(folder.resolve("seq.json"), """
                {"lightning_sequence": 1, "rig": "rig.jen", "shots": [
                  {"name": "one", "scene": "a.jen"}, {"name": "two", "scene": "a.jen", "set": ["low.intensity=1"]}]}
                """);
        JsonNode both = result("shot", "lights", sequence, "--json");
        assertThat(both.get("needless")).isEmpty();
        assertThat(both.get("lights").get(0).get("shot").asString()).isEqualTo("two");
        assertThat(result("shot", "lights", sequence, "--shots", "one", "--json").get("needless").toString()).contains("low");
    }

    @Test
    void wrongUse_isRejected() {
        CliResult.run("shot", "lights", scene, "--every", "0").assertRejected("--every must be at least 1");
        CliResult.run("shot", "lights", scene, "--steps", "300").assertRejected("--steps must be from 0 to 255");
        CliResult.run("shot", "lights", scene, "-o", scene).assertRejected("a.jen");
    }
}
