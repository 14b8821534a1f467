package lightning.review;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import lightning.sample.StudioScene;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.light.Light;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ReviewReaderTest {
    private static final String VALID = """
            {"lightning_review": 1, "scene": "studio.jen", "reviewer": "Ada", "exposure": 0.5,
             "lights": [{"name": "sun", "stops": -1, "tint": [1, 0.5, 1], "intensity": 3, "color": [1, 1, 1], "mute": false, "solo": true}],
             "groups": [{"name": "soft", "stops": null, "mute": true, "solo": false}],
             "notes": [{"x": 0.25, "y": 1, "text": "darker"}]}""";

    @TempDir
    private Path folder;

    private Review read(String text) throws IOException {
        return ReviewReader.read(Files.writeString(folder.resolve("review.json"), text));
    }

    @Test
    void validReview_isRead() throws IOException {
        Review review = read(VALID);
        assertThat(review.lights())
                .containsExactly(new Review.LightChange(new SceneElement.OfLight("sun"), true, Optional.of(-1.0), List.of(1.0, 0.5, 1.0), 3,
                        List.of(1.0, 1.0, 1.0), false, true));
        assertThat(review.groups()).containsExactly(new Review.GroupChange("soft", Optional.empty(), true, false));
        assertThat(review.notes()).containsExactly(new Review.Note(0.25, 1, "darker"));
    }

    @Test
    void environments_areRead() throws IOException {
        String world = VALID.replace("\"lightning_review\": 1", "\"lightning_review\": 2").replace("\"name\": \"sun\"",
                "\"name\": \"sun\", \"environment\": \"world\"");
        assertThat(read(world).lights()).extracting(Review.LightChange::light).containsExactly(Contribution.ENVIRONMENT);
        assertThat(read(world.replace("\"world\"", "\"dome\"")).lights()).extracting(Review.LightChange::light)
                .containsExactly(new SceneElement.OfDome("sun"));
        assertThatIOException().isThrownBy(() -> read(world.replace("\"world\"", "\"sky\"")))
                .withMessageContaining("lights[0].environment: expected \"world\" or \"dome\", found \"sky\"");
    }

    /** Pages of earlier versions have one fader for all environments. */
    @Test
    void environmentOfAnEarlierPage_isRead() throws IOException {
        String text = VALID.replace("\"name\": \"sun\"", "\"name\": \"environment\", \"environment\": true");
        assertThat(read(text).lights().getFirst().light()).isEqualTo(Contribution.ENVIRONMENT);
        assertThat(read(text).lights().getFirst().areTogether()).isTrue();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "\"lightning_review\": 1|\"lightning_review\": 3|expected version 1 or 2, found 3",
        "\"lightning_review\": 1|\"other\": 1|expected a review that a page",
        "\"stops\": -1|\"stops\": \"x\"|lights[0].stops: expected a number",
        "\"stops\": -1|\"stops\": 1e9|lights[0].stops: expected a number",
        "[1, 0.5, 1]|[1, 0.5]|lights[0].tint: expected three numbers",
        "[1, 0.5, 1]|[1, -0.5, 1]|lights[0].tint: expected three numbers",
        "\"x\": 0.25|\"x\": 2|notes[0].x: expected a number",
        "\"mute\": true|\"mute\": 1|groups[0].mute: expected true or false",
        "\"text\": \"darker\"|\"text\": 7|notes[0].text: expected a text",
        "\"x\": 0.25|\"frame\": 1.5, \"x\": 0.25|notes[0].frame: expected a whole number",
        "\"x\": 0.25|\"frame\": -1, \"x\": 0.25|notes[0].frame: expected a number",
        "\"notes\": [|\"notes\": 5, \"b\": [|notes: expected an array",
        "\"exposure\": 0.5|\"exposure\": |review.json:"})
    void changedByHand_getsOneSentenceWithThePlace(String from, String to, String expected) {
        String text = VALID.replace(from, to);
        assertThat(text).isNotEqualTo(VALID);
        assertThatIOException().isThrownBy(() -> read(text)).withMessageContaining("review.json").withMessageContaining(expected);
    }

    @Test
    void noteOfAFrame_isRead() throws IOException {
        assertThat(read(VALID.replace("{\"x\"", "{\"frame\": 12, \"x\"")).notes())
                .containsExactly(new Review.Note(OptionalInt.of(12), 0.25, 1, "darker"));
    }

    @Test
    void lightThatIsGone_isNamed() throws IOException {
        Scene scene = StudioScene.withFourLights(8, 6);
        Scene without = scene.withLights(scene.lights().stream().filter(light -> !light.name().equals("sun")).toList());
        ReviewedScene reviewed = ReviewedScene.of(without, read(VALID));
        assertThat(reviewed.notes()).anyMatch(note -> note.contains("sun")).anyMatch(note -> note.contains("soft"));
        assertThat(reviewed.scene().lights()).isEqualTo(without.lights());
    }

    @Test
    void light_getsWhatTheReviewerSaw() throws IOException {
        Scene scene = StudioScene.withFourLights(8, 6);
        Light sun = ReviewedScene.of(scene, read(VALID)).scene().light("sun").orElseThrow();
        assertThat(sun.intensity()).isEqualTo(1.5);
        assertThat(sun.color().g()).isEqualTo(0.5);
        assertThat(sun.solo()).isTrue();
    }
}
