package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
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
}
