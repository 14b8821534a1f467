package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import javax.imageio.ImageIO;
import lightning.base.math.Rgb;
import lightning.base.math.SrgbCurve;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.image.ImageFile;
import lightning.format.jen.JenReader;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.sample.PythonPrograms;
import lightning.scene.asset.TextureChannel;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TextureWrap;
import lightning.scene.material.Material;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Images of stages, through usd-core. */
class UsdTextureTest {
    private static final String STAGE = SquareStage.text("/look", 2) + """
            def Material "look"
            {
                token outputs:surface.connect = </look/surface.outputs:surface>
                def Shader "surface"
                {
                    uniform token info:id = "UsdPreviewSurface"
                    %s
                    token outputs:surface
                }
                def Shader "image"
                {
                    uniform token info:id = "UsdUVTexture"
                    asset inputs:file = @%s@
                    float3 outputs:rgb
                    float outputs:r
                }
            }
            """;
    private static final String COLOR = "color3f inputs:diffuseColor.connect = </look/image.outputs:rgb>";
    @TempDir
    private Path folder;
    private ImportedScene imported;

    @BeforeEach
    void requireUsd() {
        PythonPrograms.require("pxr");
    }

    private Material material(String input, String file) throws Exception {
        Path stage = Files.writeString(folder.resolve("a.usda"), String.format(Locale.ROOT, STAGE, input, file));
        Path scene = Files.createDirectories(folder.resolve("scene")).resolve("a.jen");
        imported = SceneImporter.read(stage, scene, LightUnits.CANDELA, Progress.NONE);
        imported.write();
        return JenReader.read(scene).scene().material("look").orElseThrow();
    }

    private void writePng(String name, int width, int height, java.util.function.IntUnaryOperator color) throws IOException {
        var image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < width * height; i++) {
            image.setRGB(i % width, i / width, color.applyAsInt(i));
        }
        ImageIO.write(image, "png", folder.resolve(name).toFile());
    }

    private void writeExr(String name, float... rgb) throws IOException {
        ImageFile.write(folder.resolve(name), Film.ofScanlines(rgb.length / 3, 1, rgb), ViewTransform.DEFAULT);
    }

    @Test
    void wrap_followsTheShader() throws Exception {
        writePng("a.png", 2, 2, i -> i);
        TextureMap map =
                material(COLOR, "a.png@\n token inputs:wrapS = \"clamp\"\n token inputs:wrapT = \"mirror\"\n asset inputs:other = @a.png")
                        .texture().orElseThrow();
        assertThat(map.wrap()).isEqualTo(new TextureWrap(TextureWrap.Edge.CLAMP, TextureWrap.Edge.MIRROR));
    }

    @Test
    void blackEdges_areNoted() throws Exception {
        writePng("a.png", 2, 2, i -> i);
        assertThat(material(COLOR, "a.png@\n token inputs:wrapS = \"black\"\n asset inputs:other = @a.png").texture().orElseThrow().wrap())
                .isEqualTo(new TextureWrap(TextureWrap.Edge.CLAMP, TextureWrap.Edge.REPEAT));
        assertThat(imported.notes()).containsEntry("textures that are black beyond their edges, whose edge pixels go on", 1);
    }

    @Test
    void unknownColorSpace_isNoted() throws Exception {
        writePng("a.png", 2, 2, i -> i);
        material(COLOR, "a.png@ (colorSpace = \"acescg\")\n asset inputs:other = @a.png");
        assertThat(imported.notes()).containsEntry("textures in the color space acescg, read as their files say", 1);
    }

    @Test
    void knownColorSpace_isNotNoted() throws Exception {
        writePng("a.png", 2, 2, i -> i);
        material(COLOR, "a.png@ (colorSpace = \"srgb_texture\")\n asset inputs:other = @a.png");
        assertThat(imported.notes().keySet()).noneMatch(note -> note.contains("color space"));
    }

    @Test
    void colorOfExr_becomesPng() throws Exception {
        writeExr("a.exr", 0.25f, 0.5f, 1, 0.001f, 3, -1);
        TextureMap map = material(COLOR, "a.exr").texture().orElseThrow();
        assertThat(map.file()).isEqualTo("a.png");
        float[] expected = {0.25f, 0.5f, 1, 0.001f, 1, 0};
        for (int i = 0; i < expected.length; i++) {
            // Half floats have 11 bits.
            assertThat(map.image().channel(i / 3, 0, i % 3)).isCloseTo(expected[i], offset(expected[i] / 2048 + 1e-5f));
        }
        assertThat(imported.notes()).containsEntry("values of OpenEXR textures above 1, limited to 1", 1);
    }

    @Test
    void numbersOfExr_stayLinear() throws Exception {
        writeExr("n.exr", 0.5f, 0.5f, 1, 0.25f, 0.75f, 1);
        TextureMap map = material("normal3f inputs:normal.connect = </look/image.outputs:rgb>", "n.exr").bumpMapping().normalMap()
                .orElseThrow();
        assertThat(map.image().channel(1, 0, 0)).isCloseTo(0.25f, offset(1e-5f));
        assertThat(map.image().channel(1, 0, 1)).isCloseTo(0.75f, offset(1e-5f));
        Material rough = material("float inputs:roughness.connect = </look/image.outputs:r>", "n.exr");
        assertThat(rough.roughness()).isEqualTo(1);
        assertThat(rough.surfaceMaps().roughnessChannel()).isEqualTo(TextureChannel.RED);
        // Codes of 16 bits.
        assertThat(rough.surfaceMaps().roughness().orElseThrow().image().channel(1, 0, 0)).isCloseTo(0.25f, offset(0.5f / 65535));
    }

    @Test
    void emission_becomesGlowMap() throws Exception {
        writePng("e.png", 2, 1, i -> i == 0 ? 0xff0000 : 0);
        Material glowing = material("color3f inputs:emissiveColor.connect = </look/image.outputs:rgb>", "e.png");
        assertThat(glowing.glow()).isEqualTo(Rgb.WHITE);
        assertThat(glowing.glowMap().orElseThrow().image().channel(0, 0, 0)).isEqualTo(1);
        assertThat(glowing.glowMap().orElseThrow().image().channel(1, 0, 0)).isEqualTo(0);
        assertThat(material("color3f inputs:emissiveColor.connect = </look/image.outputs:rgb>", "missing.png").glow()).isEqualTo(Rgb.BLACK);
    }

    @Test
    void emissionOfExr_keepsItsRange() throws Exception {
        writeExr("e.exr", 8, 4, 2, 0, 0, 0);
        Material glowing = material("color3f inputs:emissiveColor.connect = </look/image.outputs:rgb>", "e.exr");
        assertThat(glowing.glow().r()).isCloseTo(4, offset(1e-9));
        assertThat(glowing.glow().b()).isCloseTo(1, offset(1e-9));
    }

    /** Tiles 1002, 1003 and 1012 are those from (1, 0), (2, 0) and (1, 1). */
    @Test
    void tiles_becomeOneTexture() throws Exception {
        writePng("c.1002.png", 16, 16, i -> i * 0x010101);
        writePng("c.1003.png", 16, 16, _ -> 0x00FF00);
        writePng("c.1012.png", 8, 8, _ -> 0x0000FF);
        TextureMap map = material(COLOR, "c.<UDIM>.png").texture().orElseThrow();
        assertThat(map.repeatU()).isEqualTo(0.5);
        assertThat(map.repeatV()).isEqualTo(0.5);
        assertThat(map.image().width()).isEqualTo(32);
        assertThat(map.image().height()).isEqualTo(32);
        for (int i = 0; i < 256; i++) {
            // Coordinates (1 + x, y) are those of the atlas times 2, modulo 1, from the bottom: its lower right quarter.
            assertThat(map.image().channel(16 + i % 16, 16 + i / 16, 1)).isEqualTo((float) SrgbCurve.toLinear(i / 255.0));
        }
        assertThat(map.image().channel(3, 30, 1)).isEqualTo(1);
        assertThat(map.image().channel(3, 30, 0)).isZero();
        assertThat(map.image().channel(30, 3, 2)).isEqualTo(1);
        assertThat(map.image().channel(3, 3, 2)).isZero();
        assertThat(imported.notes().keySet()).noneMatch(note -> note.contains("textures"));
    }

    @Test
    void missingTiles_areNoted() throws Exception {
        assertThat(material(COLOR, "c.<UDIM>.png").texture()).isEmpty();
        assertThat(imported.notes()).containsEntry("textures that are missing", 1);
        Files.writeString(folder.resolve("c.1001.png"), "no image");
        assertThat(material(COLOR, "c.<UDIM>.png").texture()).isEmpty();
    }

    /** As in files of other formats: the last rows and columns stay. */
    @Test
    void largeTextureOfOddSize_isReducedUpward() throws Exception {
        writePng("odd.png", 4201, 4201, i -> 0xFF0000);
        assertThat(material(COLOR, "odd.png").texture().orElseThrow().image().width()).isEqualTo(2101);
    }

    @Test
    void largeTexture_isReduced() throws Exception {
        writePng("large.png", 4200, 4200, i -> i % 4200 < 2100 ? 0xFF0000 : 0x00FF00);
        TextureMap map = material(COLOR, "large.png").texture().orElseThrow();
        assertThat(map.image().width()).isEqualTo(2100);
        assertThat(map.image().channel(1000, 100, 0)).isEqualTo(1);
        assertThat(map.image().channel(1100, 100, 1)).isEqualTo(1);
        assertThat(imported.notes()).containsEntry("textures reduced to fit into a scene", 1);
    }
}
