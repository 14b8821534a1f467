package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Optional;
import javax.imageio.ImageIO;
import lightning.scene.Scene;
import lightning.scene.SceneDiff;
import lightning.scene.asset.TextureChannel;
import lightning.scene.asset.TextureWrap;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.SurfaceMaps;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Maps of roughness and metalness in scene files and edits. */
class SurfaceMapFilesTest {
    private static final String PACKED = """
            jen 1
            material m {
              model principled   # worn
              roughness_map "orm.png"
              roughness_repeat 2 3
              metalness_map "orm.png" metalness_wrap clamp
            }
            """;

    @TempDir
    Path folder;

    @BeforeEach
    void writeImage() throws Exception {
        BufferedImage image = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, 0x336699);
        ImageIO.write(image, "png", folder.resolve("orm.png").toFile());
    }

    private JenDocument read(String text) throws JenException {
        return JenReader.read(text, "s.jen", folder);
    }

    private static SurfaceMaps maps(Scene scene) {
        return scene.materials().getFirst().surfaceMaps();
    }

    @Test
    void packedImage_isLinearAndReadOnceByTwoMaps() throws Exception {
        SurfaceMaps maps = maps(read(PACKED).scene());
        assertThat(maps.roughnessChannel()).isEqualTo(TextureChannel.GREEN);
        assertThat(maps.metalnessChannel()).isEqualTo(TextureChannel.BLUE);
        assertThat(maps.roughness().orElseThrow().repeatV()).isEqualTo(3);
        assertThat(maps.metalness().orElseThrow().wrap()).isEqualTo(TextureWrap.CLAMP);
        assertThat(maps.roughness().get().image()).isSameAs(maps.metalness().get().image());
        assertThat(maps.roughness().get().image().channel(0, 0, 1)).isEqualTo(0x66 / 255f);
    }

    @Test
    void edits_changeOnlyTheirLines() throws Exception {
        JenDocument document = read(PACKED);
        Scene edited = PropertyEdit.apply(document.scene(), "material:m.roughness_channel=red", folder);
        assertThat(maps(edited).roughnessChannel()).isEqualTo(TextureChannel.RED);
        assertThat(document.withScene(edited).text()).isEqualTo(PACKED.replace("clamp\n", "clamp\n  roughness_channel red\n"));
        assertThat(SceneDiff.describe(document.scene(), edited)).isEqualTo("m: roughness channel green → red");
        Scene removed = PropertyEdit.apply(document.scene(), "material:m.roughness_map=none", folder);
        assertThat(document.withScene(removed).text()).doesNotContain("roughness").contains("metalness_map \"orm.png\"");
        assertThat(read(document.withScene(removed).text()).scene()).isEqualTo(removed);
    }

    @Test
    void otherModel_losesMaps() throws Exception {
        JenDocument document = read(PACKED);
        Scene metallic = document.scene().withMaterial(document.scene().materials().getFirst().withModel(ShadingModel.METALLIC));
        String text = document.withScene(metallic).text();
        assertThat(text).contains("model metallic").doesNotContain("orm.png", "_repeat", "_wrap");
        assertThat(read(text).scene()).isEqualTo(metallic);
    }

    @Test
    void mapOfAnotherModel_isRefused() {
        assertThatThrownBy(() -> read("jen 1\nmaterial m {\n  roughness_map \"orm.png\"\n}\n"))
                .hasMessageContaining("s.jen:3:").hasMessageContaining("a material of model phong has no roughness map");
        assertThatThrownBy(() -> PropertyEdit.apply(read("jen 1\nmaterial m { }\n").scene(), "material:m.metalness_channel=red"))
                .hasMessage("material 'm': a material of model phong has no metalness channel");
    }

    @Test
    void repeatWithoutMap_isRefused() throws Exception {
        Scene scene = read("jen 1\nmaterial m { model principled }\n").scene();
        assertThatThrownBy(() -> PropertyEdit.apply(scene, "material:m.roughness_repeat=2 2"))
                .hasMessage("material 'm': roughness_repeat needs a roughness_map, found none");
    }

    @Test
    void missingImage_isLeftOutWithANote() throws Exception {
        JenDocument document = read(PACKED.replace("roughness_map \"orm.png\"", "roughness_map \"lost.png\""));
        assertThat(document.notes()).singleElement().asString()
                .startsWith("s.jen:4:17: material 'm': there is no texture 'lost.png' in the folder ").endsWith("; left out");
        assertThat(maps(document.scene()).roughness()).isEmpty();
        Material darker = document.scene().materials().getFirst().withMetalness(0.5);
        assertThat(document.withScene(document.scene().withMaterial(darker)).text()).contains("\"lost.png\"");
    }

    @Test
    void unusedChannel_isKept() throws Exception {
        Scene scene = read("jen 1\nmaterial m { model principled roughness_channel red }\n").scene();
        assertThat(maps(scene)).isEqualTo(SurfaceMaps.NONE.withRoughnessChannel(TextureChannel.RED));
        assertThat(maps(scene).roughness()).isEqualTo(Optional.empty());
    }
}
