package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import lightning.base.text.PrintableText;
import lightning.sample.ByteFuzzer;
import lightning.sample.Slow;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

/** Edit texts with a few errors: each gives a valid scene, or a one-line printable message. */
@Slow
class EditFuzzTest {
    private static final int TRIES = ByteFuzzer.tryCount(60_000);
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
    private static final List<byte[]> ADDITIONS =
            bytes("\"rim light\" spot angle=20 at=0 1 2", "rim point", "light rim point { intensity 2 }",
                    "light \"rim { light\" spot {}");
    private static final List<byte[]> NAMES = bytes("fill", "\"key light\"", "key light", "\"a=b\\\"\"");
    private static final List<byte[]> INSERTIONS =
            bytes("\"", "\\", ".", "=", " ", "material:", "picture", "{", "}", "#", "\n", "1e999", "-1", "0x1p3",
                    "\u001B[31m", "\u202E", "\u2028", "𝐀".repeat(60), "none");

    /** Edit operation on a text. */
    private interface EditOperation {
        Scene apply(Scene scene, String arguments);
    }

    @Test
    void assignment_yieldsSceneOrError() throws JenException {
        runTries(EDITS, PropertyEdit::apply, 0.02);
    }

    @Test
    void addition_yieldsSceneOrError() throws JenException {
        runTries(ADDITIONS, PropertyEdit::add, 0.02);
    }

    @Test
    void deletion_yieldsSceneOrError() throws JenException {
        runTries(NAMES, PropertyEdit::delete, 0.001);
    }

    private static void runTries(List<byte[]> pool, EditOperation operation, double minSuccessRate) throws JenException {
        JenDocument document = JenReader.read(TEXT, "e.jen", Path.of(""));
        int successes = 0;
        for (int i = 0; i < TRIES / 3; i++) {
            SplittableRandom random = ByteFuzzer.random(i);
            String arguments = new String(ByteFuzzer.mutate(pool, random, INSERTIONS), StandardCharsets.UTF_8);
            try {
                Scene edited = operation.apply(document.scene(), arguments);
                assertThat(JenReader.read(document.withScene(edited).text(), "saved", Path.of("")).scene()).isEqualTo(edited);
                successes++;
            } catch (IllegalArgumentException e) {
                assertThat(e.getMessage()).as("try " + i + ": " + arguments).isNotBlank().matches(PrintableText::isPrintable, "is visible")
                        .hasSizeLessThan(2000);
            } catch (JenException | RuntimeException | AssertionError e) {
                throw new AssertionError("try " + i + ": " + arguments, e);
            }
        }
        assertThat(successes).isBetween((int) (minSuccessRate * TRIES / 3), TRIES / 3 - 1);
    }

    private static List<byte[]> bytes(String... texts) {
        return Stream.of(texts).map(text -> text.getBytes(StandardCharsets.UTF_8)).toList();
    }
}
