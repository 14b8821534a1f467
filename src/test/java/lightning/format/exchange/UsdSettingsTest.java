package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.sample.PythonPrograms;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TexturePlacement;
import lightning.scene.value.Lens;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Settings of stages that change the picture: of render settings, cameras, bindings and primvars; through usd-core. */
class UsdSettingsTest {
    private static final String SQUARE = """
            int[] faceVertexCounts = [4]
            int[] faceVertexIndices = [0, 1, 2, 3]
            point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
            uniform token subdivisionScheme = "none"
            texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] ( interpolation = "vertex" )
            """;
    private static final String MATERIAL = """
            def Material "red" {
                token outputs:surface.connect = </red/s.outputs:surface>
                def Shader "s" {
                    uniform token info:id = "UsdPreviewSurface"
                    color3f inputs:diffuseColor = (1, 0, 0)
                    %s
                    token outputs:surface
                }
                def Shader "image" {
                    uniform token info:id = "UsdUVTexture"
                    asset inputs:file = @w.png@
                    float2 inputs:st.connect = </red/move.outputs:result>
                    float3 outputs:rgb
                }
                def Shader "move" {
                    uniform token info:id = "UsdTransform2d"
                    float2 inputs:in.connect = </red/uv.outputs:result>
                    float2 inputs:scale = (2, 1)
                    float inputs:rotation = 90
                    float2 inputs:translation = (0.5, 0.25)
                    float2 outputs:result
                }
                def Shader "uv" {
                    uniform token info:id = "UsdPrimvarReader_float2"
                    string inputs:varname = "st"
                    float2 outputs:result
                }
            }
            """;
    @TempDir
    private Path folder;

    @BeforeEach
    void requireUsd() {
        PythonPrograms.require("pxr");
    }

    private ImportedScene imported(String metadata, String prims) throws Exception {
        Path file = Files.writeString(folder.resolve("a.usda"),
                "#usda 1.0\n(\n upAxis = \"Y\"\n metersPerUnit = 1\n" + metadata + ")\n" + prims);
        return SceneImporter.read(file, folder.resolve("a.jen"), LightUnits.CANDELA, Progress.NONE);
    }

    private static String square(String more) {
        return "def Mesh \"thing\" ( prepend apiSchemas = [\"MaterialBindingAPI\"] )\n{\n" + SQUARE + more + "\n}\n";
    }

    @ParameterizedTest
    @ValueSource(strings = {"material:binding", "material:binding:full", "material:binding:preview"})
    void bindingOfAnyPurpose_isUsed(String binding) throws Exception {
        ImportedScene scene = imported("", square("rel " + binding + " = </red>") + MATERIAL.replace("%s", ""));
        assertThat(scene.scene().placedShapes().getFirst().material().base()).isEqualTo(new Rgb(1, 0, 0));
    }

    @ParameterizedTest
    @CsvSource({"full, other", "preview, red"})
    void bindingForFull_winsOverTheGeneralOneAndThatOverPreview(String purpose, String material) throws Exception {
        ImportedScene scene = imported("", square("rel material:binding = </red>\nrel material:binding:" + purpose + " = </other>")
                + MATERIAL.replace("%s", "") + MATERIAL.replace("%s", "").replace("red", "other").replace("(1, 0, 0)", "(0, 1, 0)"));
        assertThat(scene.scene().placedShapes().getFirst().material().name()).isEqualTo(material);
    }

    @Test
    void fallbackColor_standsForAMissingTexture() throws Exception {
        ImportedScene scene = imported("", square("rel material:binding = </red>") + MATERIAL.replace("%s", "")
                .replace("inputs:diffuseColor = (1, 0, 0)", "inputs:diffuseColor.connect = </red/image.outputs:rgb>")
                .replace("@w.png@", "@gone.png@\nfloat4 inputs:fallback = (0, 1, 0, 1)"));
        assertThat(scene.scene().placedShapes().getFirst().material().base()).isEqualTo(new Rgb(0, 1, 0));
        assertThat(scene.notes()).containsEntry("textures that are missing, replaced by their fallback color", 1);
    }

    @Test
    void indexedConstantColor_isThatOfItsIndex() throws Exception {
        ImportedScene scene = imported("", square("""
                color3f[] primvars:displayColor = [(1, 0, 0), (0, 1, 0)] ( interpolation = "constant" )
                int[] primvars:displayColor:indices = [1]
                """));
        assertThat(scene.scene().placedShapes().getFirst().material().diffuse()).isEqualTo(new Rgb(0, 1, 0));
    }

    /** 2 stops; a time of 1/50 s with ISO 200 at f/2 is 1/100. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"float exposure = 2 | 2",
        "float exposure:time = 0.02; float exposure:iso = 200; float exposure:fStop = 2 | -6.643856189"})
    void exposureOfCamera_isThatOfThePicture(String attributes, double stops) throws Exception {
        ImportedScene scene = imported("", square("") + "def Camera \"eye\" {\n" + attributes.replace("; ", "\n") + "\n}\n");
        assertThat(scene.scene().picture().view().exposure()).isCloseTo(stops, offset(1e-6));
    }

    /** A focal length of 50 is 5 scene units, so f/2 is a radius of 1.25. */
    @Test
    void fNumberAndFocusDistance_areTheLens() throws Exception {
        String camera = "def Camera \"eye\" {\nfloat focalLength = 50\nfloat fStop = 2\nfloat focusDistance = 7\n}\n";
        assertThat(imported("", square("") + camera).scene().camera().lens()).isEqualTo(new Lens(1.25, 7, 0, 0));
        assertThat(imported("", square("") + camera.replace("fStop = 2", "fStop = 0")).scene().camera().lens()).isEqualTo(Lens.PINHOLE);
        ImportedScene unfocused = imported("", square("") + camera.replace("focusDistance = 7", "focusDistance = 0"));
        assertThat(unfocused.scene().camera().lens()).isEqualTo(Lens.PINHOLE);
        assertThat(unfocused.notes()).containsEntry("depth of field of cameras without a focus distance", 1);
    }

    @Test
    void animatedFocusDistance_becomesKeyframes() throws Exception {
        ImportedScene scene = imported(" startTimeCode = 1\n endTimeCode = 3\n", square("")
                + "def Camera \"eye\" {\nfloat focalLength = 50\nfloat fStop = 2\nfloat focusDistance.timeSamples = { 1: 4, 3: 8 }\n}\n");
        assertThat(scene.shot().orElseThrow().sceneAt(scene.scene(), 2).camera().lens().focus()).isEqualTo(6);
    }

    @Test
    void resolutionOfRenderSettings_isThatOfThePicture() throws Exception {
        ImportedScene scene = imported(" renderSettingsPrimPath = \"/settings\"\n",
                square("") + "def RenderSettings \"settings\" {\nuniform int2 resolution = (320, 200)\n}\n");
        assertThat(scene.scene().picture().width()).isEqualTo(320);
        assertThat(scene.scene().picture().height()).isEqualTo(200);
    }

    /** Scale by 2 along u, then a quarter turn, then the translation: (u, v) goes to (2u, v), (−v, 2u) and (0.5 − v, 0.25 + 2u). */
    @Test
    void transformOfTexture_isItsPlacement() throws Exception {
        ImageIO.write(new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB), "png", folder.resolve("w.png").toFile());
        ImportedScene scene = imported("", square("rel material:binding = </red>")
                + MATERIAL.replace("%s", "color3f inputs:diffuseColor.connect = </red/image.outputs:rgb>").replaceFirst(
                        "color3f inputs:diffuseColor = \\(1, 0, 0\\)", ""));
        TextureMap map = scene.scene().placedShapes().getFirst().material().texture().orElseThrow();
        assertThat(map.repeatU()).isEqualTo(2);
        assertThat(map.repeatV()).isEqualTo(1);
        assertThat(map.placement()).isEqualTo(new TexturePlacement(0.5, 0.25, 90));
        assertThat(scene.notes().keySet()).noneMatch(note -> note.contains("rotation"));
    }
}
