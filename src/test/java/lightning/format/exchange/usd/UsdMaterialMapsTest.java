package lightning.format.exchange.usd;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.gltf.JsonValue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.json.JsonMapper;

/** Tests which textures of a stage's materials share the limit of a scene's pixels. */
class UsdMaterialMapsTest {
    @TempDir
    private Path folder;

    @Test
    void shownTextures_areCounted() throws Exception {
        String text =
                """
                        {"textures": {"diffuseColor": {"file": "color.png"}, "normal": {"file": "normal.png"}, "opacity": {"file": "opacity.png"},
                            "emissiveColor": {"file": "glow.png"}, "roughness": {"file": "rough.png"}, "metallic": {"file": "metal.png"}, "displacement": {"file": "height.png"}}}
                        """;
        JsonValue material = new JsonValue(folder.resolve("a.usda"), "", JsonMapper.builder().build().readTree(text));
        var textures = new UsdTextures(new SceneAssembler(folder.resolve("a.usda"), folder.resolve("a.jen")));
        assertThat(new UsdMaterialImport(new SceneAssembler(folder.resolve("a.usda"), folder.resolve("a.jen")), textures).maps(material))
                .map(image -> image.get("file").text().orElseThrow())
                .containsExactlyInAnyOrder("color.png", "normal.png", "opacity.png", "glow.png", "rough.png", "metal.png");
    }
}
