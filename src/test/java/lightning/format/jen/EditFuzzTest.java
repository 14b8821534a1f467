package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import lightning.base.text.Visible;
import lightning.sample.Fuzz;
import lightning.sample.Slow;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

/** Edits in words with a few mistakes: each gives a scene that a file can say, or a refusal in one visible line. */
@Slow
class EditFuzzTest {
    private static final int TRIES = Fuzz.tries(60_000);
    private static final String TEXT = """
            jen 1
            material "old oak" { shininess 3 }
            material m {}
            group g { sphere "b.1" { material "old oak" } }
            light "key light" spot {}
            light "a=b\\"" point {}
            light fill directional {}
            """;
    private static final List<byte[]> EDITS =
            bytes("\"key light\".intensity=2", "fill.color=1 0.5 0", "\"a=b\\\"\".on=no", "key light.at=1 2 3",
                    "material:\"old oak\".shininess=30", "material:m.diffuse=1 0 0", "picture.size=640 480", "world.ambience=0.1",
                    "fill.type=spot", "fill.name=\"rim light\"", "\"b.1\".material=m", "g.scale=1 2 1", "old oak.texture=none",
                    "m.texture=\"a.png\"");
    private static final List<byte[]> ADDED = bytes("\"rim light\" spot angle=20 at=0 1 2", "rim point", "light rim point { intensity 2 }",
            "light \"rim { light\" spot {}");
    private static final List<byte[]> NAMES = bytes("fill", "\"key light\"", "key light", "\"a=b\\\"\"");
    private static final List<byte[]> BITS =
            bytes("\"", "\\", ".", "=", " ", "material:", "picture", "{", "}", "#", "\n", "1e999", "-1", "0x1p3",
                    "\u001B[31m", "\u202E", "\u2028", "𝐀".repeat(60), "none");

    /** What a try does with its words. */
    private interface Way {
        Scene of(Scene scene, String words);
    }

    @Test
    void assignment_givesASceneOrARefusal() throws JenException {
        tries(EDITS, PropertyEdit::apply, 0.02);
    }

    @Test
    void addition_givesASceneOrARefusal() throws JenException {
        tries(ADDED, PropertyEdit::add, 0.02);
    }

    @Test
    void deletion_givesASceneOrARefusal() throws JenException {
        tries(NAMES, PropertyEdit::delete, 0.001);
    }

    private static void tries(List<byte[]> pool, Way way, double leastRight) throws JenException {
        JenDocument document = JenReader.read(TEXT, "e.jen", Path.of(""));
        int right = 0;
        for (int i = 0; i < TRIES / 3; i++) {
            SplittableRandom random = Fuzz.random(i);
            String words = new String(Fuzz.mutated(pool, random, BITS), StandardCharsets.UTF_8);
            try {
                Scene edited = way.of(document.scene(), words);
                assertThat(JenReader.read(document.with(edited).text(), "saved", Path.of("")).scene()).isEqualTo(edited);
                right++;
            } catch (IllegalArgumentException e) {
                assertThat(e.getMessage()).as("try " + i + ": " + words).isNotBlank().matches(Visible::is, "is visible")
                        .hasSizeLessThan(2000);
            } catch (JenException | RuntimeException | AssertionError e) {
                throw new AssertionError("try " + i + ": " + words, e);
            }
        }
        assertThat(right).isBetween((int) (leastRight * TRIES / 3), TRIES / 3 - 1);
    }

    private static List<byte[]> bytes(String... texts) {
        return Stream.of(texts).map(text -> text.getBytes(StandardCharsets.UTF_8)).toList();
    }
}
