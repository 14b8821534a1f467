package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import lightning.base.math.Rgb;
import lightning.render.image.Film;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Scene;
import lightning.scene.material.Material;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Scene files whose images and profiles cannot be used. */
class LeftOutFilesTest {
    private static final String MISSING = """
            jen 1
            material m {
              diffuse 0.5 0.25 0.125
              texture "wood.png"   # oak
              repeat 2 3
            }
            material n { }
            """;

    @TempDir
    Path folder;

    @Test
    void missingTexture_isReplacedByItsFactor() throws Exception {
        assertThat(read(MISSING).scene().materials().getFirst()).isEqualTo(
                read("jen 1 material m { diffuse 0.5 0.25 0.125 }").scene().materials().getFirst());
    }

    @Test
    void missingTexture_isNotedWithItsPlace() throws Exception {
        assertThat(read(MISSING).notes()).singleElement().asString().startsWith(
                "s.jen:4:11: material 'm': there is no texture 'wood.png' in the folder ").endsWith("; left out");
    }

    @Test
    void editOfItsMaterial_keepsTheName() throws Exception {
        JenDocument document = read(MISSING);
        JenDocument edited = document.withScene(withDiffuse(document.scene(), Rgb.BLACK));
        assertThat(edited.text()).isEqualTo(MISSING.replace("0.5 0.25 0.125", "0 0 0"));
        assertThat(edited.withScene(document.scene()).text()).isEqualTo(MISSING);
    }

    /** A mesh whose file no scene can have stays in the scene, so an editor must be able to write it. */
    @Test
    void meshWithImpossibleFile_isWrittenAgain() throws Exception {
        Scene scene = read("jen 1 mesh m { file \"C:\\\\chair.obj\" }").scene();
        assertThat(read(JenWriter.write(scene)).scene()).isEqualTo(scene);
    }

    private static Scene withDiffuse(Scene scene, Rgb diffuse) {
        Material material = scene.materials().getFirst().withDiffuse(diffuse);
        return scene.withMaterials(List.of(material, scene.materials().getLast()));
    }

    @Test
    void newTexture_replacesTheMissingOne() throws Exception {
        write("oak.png", 1, 1);
        JenDocument document = read(MISSING);
        Scene edited = PropertyEdit.apply(document.scene(), "material:m.texture=\"oak.png\"", folder);
        assertThat(document.withScene(edited).text()).contains("texture \"oak.png\"").doesNotContain("wood.png");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "material m { normal_map \"a.png\" } | 1:31",
        "material m { model principled roughness_map \"a.png\" } | 1:51",
        "material m { cutout \"a.png\" } | 1:27",
        "light l spot { gobo \"a.png\" } | 1:27",
        "light l spot { profile \"a.ies\" } | 1:30",
        "light l rect { texture \"a.exr\" } | 1:30",
        "world { environment \"a.hdr\" } | 1:27",
        "dome d { environment \"a.hdr\" } | 1:28",
        "mesh m { file \"a.ply\" } | 1:21",
        "mesh m { file \"a.glb\" part chair } | 1:21",
        "group g { mesh m { file \"a.obj\" } } | 1:31",
        "material m { texture \"../a.png\" } | 1:28",
        "material m { texture \"C:a.png\" } | 1:28",
    })
    void fileThatCannotBeUsed_refusesNoScene(String block, String place) throws Exception {
        assertThat(read("jen 1 " + block).notes()).singleElement().asString().startsWith("s.jen:" + place + ": ").endsWith("; left out");
    }

    private static final String MISSING_MESH = """
            jen 1
            sphere ball { at 0 1 0 }
            group table { at 1 0 0
              mesh chair { file "furniture.glb" part "chair 1"  colors no  at 2 0 0 }   # oak
            }
            light lamp point { at 0 3 0  illuminates only "chair" }
            shot { frames 1 2
              group table { at { 1 1 0 0  2 1 0 5 } }
            }
            """;

    @Test
    void missingMesh_keepsItsNodeAndText() throws Exception {
        JenDocument document = read(MISSING_MESH);
        assertThat(document.scene().stage().hasNode("chair")).isTrue();
        assertThat(document.text()).isEqualTo(MISSING_MESH);
        Scene edited = PropertyEdit.apply(document.scene(), "chair.at=0 0 7");
        assertThat(document.withScene(edited).text()).isEqualTo(MISSING_MESH.replace("at 2 0 0", "at 0 0 7"));
        assertThat(JenWriter.write(document.scene())).contains("file \"furniture.glb\"", "chair 1");
    }

    @Test
    void missingMesh_isNotSeen() throws Exception {
        String light = "light l point { at 1 5 4 } plane floor { scale 9 1 9 } ";
        String mesh = "mesh m { file \"a.ply\" at 0 0.5 0 scale 3 3 3 } ";
        assertThat(trace("jen 1 " + light + mesh).hasSameBits(trace("jen 1 " + light))).isTrue();
    }

    private Film trace(String text) throws JenException {
        return new ReferenceTracer(read(text).scene()).trace();
    }

    @Test
    void missingMesh_isNotCopied() throws Exception {
        assertThat(ReferencedFiles.of(read(MISSING_MESH).scene(), folder)).isEmpty();
    }

    @Test
    void editThatNamesAMissingMesh_isRefused() throws Exception {
        Files.writeString(folder.resolve("b.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        Scene scene = read("jen 1 mesh m { file \"b.obj\" }").scene();
        assertThatThrownBy(() -> PropertyEdit.apply(scene, "m.file=\"a.ply\"", folder)).hasMessageContaining(
                "there is no mesh file 'a.ply'");
    }

    @Test
    void tooLargeTexture_isReduced() throws Exception {
        write("a.png", 4096, 4097);
        JenDocument document = read("jen 1 material m { texture \"a.png\" }");
        assertThat(document.scene().materials().getFirst().texture().orElseThrow().image().width()).isEqualTo(2048);
        assertThat(document.notes()).singleElement().asString()
                .endsWith("material 'm': texture 'a.png' has 16781312 pixels; reduced to 2048×2049");
    }

    @Test
    void edit_doesNotReduce() throws Exception {
        write("a.png", 4096, 4097);
        Scene scene = read("jen 1 material m {}").scene();
        assertThatThrownBy(() -> PropertyEdit.apply(scene, "material:m.texture=\"a.png\"", folder))
                .isInstanceOf(IllegalArgumentException.class).hasMessageContaining("has 16781312 pixels");
    }

    @Test
    void nameInAnotherCase_isFound() throws Exception {
        Files.createDirectory(folder.resolve("Textures"));
        write("Wood.PNG", 3, 1);
        JenDocument document = read("jen 1 material m { texture \"wood.png\" }");
        assertThat(document.notes()).isEmpty();
        assertThat(document.scene().materials().getFirst().texture().orElseThrow().image().width()).isEqualTo(3);
    }

    @Test
    void nameOfTwoFilesInOtherCases_isNotFound() throws Exception {
        write("Wood.png", 3, 1);
        write("WOOD.png", 3, 1);
        assertThat(read("jen 1 material m { texture \"wood.png\" }").notes()).hasSize(1);
    }

    @Test
    void rigWithAMissingFile_isRefused() throws Exception {
        Path rig = Files.writeString(folder.resolve("rig.jen"), "jen 1 light l spot { gobo \"a.png\" }");
        assertThatThrownBy(() -> JenReader.readLights(rig, folder, read("jen 1").scene().stage())).isInstanceOf(JenException.class)
                .hasMessageContaining("there is no texture 'a.png'");
    }

    private void write(String name, int width, int height) throws IOException {
        ImageIO.write(new BufferedImage(width, height, BufferedImage.TYPE_BYTE_GRAY), "png", folder.resolve(name).toFile());
    }

    private JenDocument read(String text) throws JenException {
        return JenReader.read(text, "s.jen", folder);
    }
}
