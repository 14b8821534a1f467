package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import lightning.base.text.DecimalNumber;
import lightning.format.jen.asset.JenLimits;
import lightning.format.jen.asset.MeshBlockTest;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightType;
import lightning.scene.value.SceneLimits;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Consistency of the format's documentation with the reader: its examples are valid, its tables match. */
class FormatDocumentTest {
    private static final Pattern EXAMPLE = Pattern.compile("```jen\n(.*?)```", Pattern.DOTALL);

    @TempDir
    Path folder;

    static Stream<String> examples() throws IOException {
        return EXAMPLE.matcher(page()).results().map(r -> r.group(1));
    }

    static Stream<BlockType<?>> blocks() {
        return BlockTypesTest.types();
    }

    @ParameterizedTest
    @MethodSource("examples")
    void everyExample_roundTrips(String example) throws Exception {
        for (String image : List.of("wood.png", "film.png")) {
            ImageIO.write(new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB), "png", folder.resolve(image).toFile());
        }
        Files.writeString(folder.resolve("statue.ply"), MeshBlockTest.TRIANGLE);
        String text = example.startsWith("jen") ? example : "jen 1\n" + example;
        JenDocument document = JenReader.read(text, "docs/jen-format.md", folder);
        assertThat(document.text()).isEqualTo(text);
        assertThat(JenReader.read(JenWriter.write(document.scene()), "written", folder).scene()).isEqualTo(document.scene());
    }

    @ParameterizedTest
    @MethodSource("blocks")
    void everyBlock_hasAnExample(BlockType<?> type) throws IOException {
        assertThat(examples()).anyMatch(e -> Pattern.compile("\\b" + type.keyword() + "\\b[^\n]*\\{").matcher(e).find());
    }

    @ParameterizedTest
    @MethodSource("blocks")
    void everyProperty_isDocumented(BlockType<?> type) throws IOException {
        assertThat(page().lines()).containsAll(type.properties().stream().map(FormatDocumentTest::row).toList());
    }

    @Test
    void everyLightType_isDocumentedWithItsAttributes() throws IOException {
        for (LightType type : LightType.values()) {
            List<String> acting = LightAttribute.ALL.stream().filter(a -> a.term(type).isPresent()).map(a -> "`" + a.name() + "`").toList();
            boolean all = LightAttribute.ALL.stream().allMatch(a -> a.appliesTo(type));
            assertThat(page()).contains(
                    "| `" + LightAttribute.TYPE.kind().format(type) + "` | " + (all ? "all of them" : String.join(", ", acting)) + " |");
        }
    }

    @Test
    void everyLimit_isDocumented() throws IOException {
        for (int limit : List.of(JenLimits.MESHES, JenLimits.TRIANGLES, JenLimits.TOKENS, JenLimits.TOKEN_LENGTH, JenLimits.PROBLEMS,
                JenLimits.TEXTURES,
                JenLimits.TEXTURE_SIDE, SceneLimits.MAX_LIGHTS, SceneLimits.MAX_SHAPES, SceneLimits.MAX_MATERIALS,
                SceneLimits.MAX_NESTING)) {
            assertThat(page()).contains("| " + limit + " |");
        }
        assertThat(page()).contains("| " + (JenLimits.FILE_BYTES >> 20) + " MiB |",
                "| " + (JenLimits.TEXTURE_BYTES >> 20) + " MiB |", "| " + (JenLimits.TEXTURE_PIXELS >> 20) + " Mi |",
                "| " + (JenLimits.TOTAL_TEXTURE_PIXELS >> 20) + " Mi |");
    }

    /** Returns the row of a property in the document's tables. */
    static String row(Property<?> p) {
        String initial = p.initial() instanceof Value.Absent ? "none" : "`" + p.initial().text() + "`";
        String value = switch (p.form()) {
            case NUMBERS ->
                    (p.count() == 1 ? "" : p.count() + " ") + (p.isInteger() ? "whole " : "") + (p.count() == 1 ? "number" : "numbers:"
                            + String.join(",", p.labels()));
            case LINKS -> "`all`, `none`, or `only` or `except` and names in quotes";
            case GAINS -> "names in quotes, each with a number";
            case WORD -> "`" + String.join("`, `", p.choices()) + "`";
            case NAME -> "name";
            case QUOTED -> "file name in quotes";
            case BLOCK -> "block";
        };
        String range = p.form() == Property.Form.NUMBERS || p.form() == Property.Form.GAINS
                ? DecimalNumber.format(p.min()) + " … " + DecimalNumber.format(p.max()) : "";
        return ("| `" + p.name() + "` | " + value + " | " + initial + " | " + range + " | " + p.unit() + " |").replaceAll(" +", " ");
    }

    private static String page() throws IOException {
        return Files.readString(Path.of("docs/jen-format.md"));
    }
}
