package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import lightning.scene.World;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.light.LightAttribute;
import org.junit.jupiter.api.Test;

/** The add-on for Blender sends words without quotes, which only its own list of properties tells from names. */
class BlenderWordsTest {
    @Test
    void choicesOfLightsAndOfTheWorld_areInTheListOfTheAddOn() throws IOException {
        String list = Files.readAllLines(Path.of("src/main/blender/lightning/words.py")).stream()
                .filter(line -> line.startsWith("CHOICES")).findFirst().orElseThrow();
        List<String> choices = Stream.<SceneAttribute<?, ?>>concat(LightAttribute.ALL.stream(), World.ATTRIBUTES.stream())
                .filter(a -> a.kind() instanceof ChoiceKind<?> && a.kind() != ChoiceKind.YES_OR_NO).map(a -> '"' + a.name() + '"').toList();
        assertThat(choices).contains("\"filter\"", "\"falloff\"");
        assertThat(list).contains(choices);
    }
}
