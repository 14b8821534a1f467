package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import lightning.document.LooksFolder;
import lightning.format.jen.JenReader;
import lightning.scene.Scene;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class ReviewCommandTest {
    private static final String REVIEW = """
            {"lightning_review": 1, "scene": "a.jen", "reviewer": "Ada", "exposure": 0,
             "lights": [{"name": "sun", "stops": 1, "tint": [1, 1, 1], "intensity": 0.4, "color": [1, 1, 1], "mute": false, "solo": false},
                        {"name": "gone", "stops": 1, "tint": [1, 1, 1], "intensity": 1, "color": [1, 1, 1], "mute": false, "solo": false}],
             "groups": [], "notes": [{"x": 0.5, "y": 0.5, "text": "warmer"}]}""";

    @TempDir
    private Path folder;
    private Path scene;

    @BeforeEach
    void write() throws IOException {
        scene = CliResult.scene(folder);
    }

    @Test
    void page_isOneFileWithoutAddresses() throws IOException {
        Path page = folder.resolve("a.html");
        CliResult result = CliResult.run("review", scene, "-o", page).assertSuccess();
        assertThat(result.out()).contains("about", "3 lights, 48 x 32 pixels");
        String text = Files.readString(page);
        assertThat(text).startsWith("<!doctype html>").contains("default-src 'none'", "\"name\":\"lamp\"").doesNotContain("http://",
                "https://", "{{");
        try (var files = Files.list(folder)) {
            assertThat(files).containsExactlyInAnyOrder(scene, page);
        }
    }

    @Test
    void appliedReview_setsLightsAndPrintsNotes() throws Exception {
        Path review = Files.writeString(folder.resolve("review.json"), REVIEW);
        Path reviewed = folder.resolve("reviewed.jen");
        CliResult result = CliResult.run("review", scene, "--apply", review, "-o", reviewed).assertSuccess();
        assertThat(result.out()).contains("Ada", "1 note", "24,16: warmer");
        assertThat(result.err()).contains("there is no light", "gone");
        Scene found = JenReader.read(reviewed).scene();
        assertThat(found.light("sun").orElseThrow().intensity()).isEqualTo(0.8);
        assertThat(Files.readString(reviewed)).contains("# what lights it");
    }

    @Test
    void json_hasNotesInPixels() throws IOException {
        Path review = Files.writeString(folder.resolve("review.json"), REVIEW);
        JsonNode report =
                new JsonMapper().readTree(CliResult.run("review", scene, "--apply", review, "--json").assertSuccess().out()).get("result");
        assertThat(report.at("/comments/0/x").asInt()).isEqualTo(24);
        assertThat(report.at("/comments/0/text").asString()).isEqualTo("warmer");
        assertThat(report.get("reviewer").asString()).isEqualTo("Ada");
        assertThat(report.has("bytes")).isFalse();
    }

    @Test
    void wrongUse_isRejected() throws IOException {
        CliResult.run("review", scene).assertRejected("-o page.html", "--apply");
        CliResult.run("review", scene, "-o", folder.resolve("a.png")).assertRejected("a.png", ".html");
        Path review = Files.writeString(folder.resolve("review.json"), "{}");
        CliResult.run("review", scene, "--apply", review).assertRejected("review.json", "expected a review");
        CliResult.run("review", scene, "--apply", folder.resolve("none.json")).assertRejected("none.json");
        CliResult.run("review", scene, "--apply", review, "-o", folder.resolve("a.html")).assertRejected("-o is a scene");
    }

    private static JsonNode report(Object... words) {
        return new JsonMapper().readTree(CliResult.run(words).assertSuccess().out()).get("result");
    }

    @Test
    void view_isThatOfThePage() throws IOException {
        Path page = folder.resolve("a.html");
        CliResult.run("review", scene, "-o", page, "--view", "agx").assertSuccess();
        assertThat(Files.readString(page)).contains("\"AgX\"");
        CliResult.run("review", scene, "--apply", folder.resolve("none.json"), "--view", "agx").assertRejected("--view");
    }

    @Test
    void shot_becomesAFilmstrip() {
        Path page = folder.resolve("dusk.html");
        JsonNode report = report("review", "scenes/dusk.jen", "-o", page, "--size", "12x8", "--json");
        assertThat(report.get("frames").valueStream().map(JsonNode::asInt)).containsExactly(1, 8, 14, 21, 28, 35, 41, 48);
        report = report("review", "scenes/dusk.jen", "-o", page, "--size", "12x8", "--frames", "24,3,24", "--json");
        assertThat(report.get("frames").valueStream().map(JsonNode::asInt)).containsExactly(24, 3);
        CliResult result = CliResult.run("review", "scenes/dusk.jen", "-o", page, "--size", "12x8", "--frames", "24,3").assertSuccess();
        assertThat(result.out()).contains("2 frames, 12 x 8 pixels, about", "2 frames, 4 lights");
    }

    @Test
    void looks_areOnThePage() throws IOException {
        Path page = folder.resolve("a.html");
        Path looks = Files.createDirectory(LooksFolder.of(scene));
        Files.writeString(looks.resolve("warm.jen"), "jen 1\nlight sun directional { direction 0.4 -1 -0.5  intensity 2 }\n");
        Files.writeString(looks.resolve("broken.jen"), "jen 1\nlight\n");
        JsonNode report = report("review", scene, "-o", page, "--json");
        assertThat(report.get("looks").valueStream().map(JsonNode::asString)).containsExactly("warm");
        assertThat(CliResult.run("review", scene, "-o", page).assertSuccess().err()).contains("broken.jen:");
        assertThat(report("review", scene, "-o", page, "--no-looks", "--json").get("looks").size()).isZero();
        assertThat(report("review", scene, "-o", page, "--look", "warm", "--json").get("looks").size()).isEqualTo(1);
        CliResult.run("review", scene, "-o", page, "--look", "cold").assertRejected("no look 'cold'", "broken, warm");
    }

    @Test
    void noteOfAFrame_namesIt() throws Exception {
        Path review = Files.writeString(folder.resolve("review.json"), REVIEW.replace("{\"x\"", "{\"frame\": 9, \"x\""));
        assertThat(CliResult.run("review", scene, "--apply", review).assertSuccess().out()).contains("frame 9, 24,16: warmer");
        assertThat(report("review", scene, "--apply", review, "--json").at("/comments/0/frame").asInt()).isEqualTo(9);
    }

    @Test
    void wrongFramesAndLanguages_areRejected() throws IOException {
        Path page = folder.resolve("a.html");
        CliResult.run("review", scene, "-o", page, "--frames", "1").assertRejected("no shot block");
        CliResult.run("review", "scenes/dusk.jen", "-o", page, "--frames", "1,49").assertRejected("from 1 to 48", "49");
        CliResult.run("review", scene, "-o", page, "--language", "fr").assertRejected("fr");
        CliResult.run("review", scene, "-o", page, "--look", "a", "--no-looks").assertRejected("--no-looks");
        CliResult.run("review", scene, "--live", "--frames", "1").assertRejected("--frames");
        CliResult.run("review", "scenes/dusk.jen", "-o", page, "--size", "4000x4000").assertRejected("at most 500 MB", "fewer frames");
        assertThat(page).doesNotExist();
    }
}
