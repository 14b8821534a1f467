package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.sample.PythonPrograms;
import lightning.scene.Scene;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.node.Shape;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Meshes of stages whose surfaces are lights. */
class UsdMeshLightTest {
    private static final String MESH = """
            float inputs:intensity = 40
            color3f inputs:color = (1, 0.5, 0.25)
            int[] faceVertexCounts = [4]
            int[] faceVertexIndices = [0, 1, 2, 3]
            point3f[] points = [(-1, 0, -1), (1, 0, -1), (1, 0, 1), (-1, 0, 1)]
            """;
    private static final String STAGE = """
            #usda 1.0
            (
                metersPerUnit = 1
                upAxis = "Y"
            )
            def Mesh "bare" ( prepend apiSchemas = ["MeshLightAPI"] )
            {
            """ + MESH + """
            }
            def Mesh "lamp" ( prepend apiSchemas = ["MeshLightAPI", "MaterialBindingAPI"] )
            {
            """ + MESH + """
                bool inputs:normalize = 1
                rel material:binding = </paint>
            }
            def Mesh "plain"
            {
                int[] faceVertexCounts = [3]
                int[] faceVertexIndices = [0, 1, 2]
                point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
            }
            def Material "paint" {}
            """;
    @TempDir
    private Path folder;
    private JenDocument document;

    private ImportedScene read() throws Exception {
        Files.writeString(folder.resolve("shot.usda"), STAGE);
        ImportedScene imported =
                SceneImporter.read(folder.resolve("shot.usda"), folder.resolve("shot.jen"), LightUnits.CANDELA, Progress.NONE);
        imported.write();
        document = JenReader.read(folder.resolve("shot.jen"));
        return imported;
    }

    @BeforeEach
    void requireUsd() {
        PythonPrograms.require("pxr");
    }

    private static Light light(Scene scene, String shape) {
        return scene.lights().stream().filter(l -> l.area().shape().equals(shape)).findFirst().orElseThrow();
    }

    private static boolean isSeen(Scene scene, String shape) {
        return ((Shape) scene.stage().node(shape).orElseThrow()).visible();
    }

    @Test
    void mesh_isALightOfItsLuminance() throws Exception {
        ImportedScene imported = read();
        Light bare = light(document.scene(), "bare");
        assertThat(bare.type()).isEqualTo(LightType.OBJECT);
        assertThat(bare.emission().unit()).isEqualTo(IntensityUnit.NIT);
        assertThat(bare.intensity()).isEqualTo(40);
        assertThat(isSeen(document.scene(), "bare")).as("without a material").isFalse();
        assertThat(imported.notes()).containsEntry("mesh lights without a material, hidden from the camera", 1);
    }

    /** The luminance of a normalized light is its intensity over its area, here 4. */
    @Test
    void meshWithMaterial_glowsAsItsLight() throws Exception {
        read();
        Scene scene = document.scene();
        assertThat(isSeen(scene, "lamp")).isTrue();
        String material = ((Shape) scene.stage().node("lamp").orElseThrow()).material();
        assertThat(scene.materialsByName().get(material).emission().r()).isBetween(9.999, 10.001);
    }

    @Test
    void unchangedLight_writesNothing() throws Exception {
        read();
        assertThat(export(document.scene())).doesNotContain("inputs:");
    }

    @Test
    void editedLight_isWrittenToItsMesh() throws Exception {
        read();
        Scene scene = document.scene();
        String layer = export(scene.withLight(light(scene, "bare").withIntensity(7)));
        assertThat(layer).contains("over \"bare\"", "inputs:intensity = 7").doesNotContain("xformOp", "inputs:radius");
    }

    @Test
    void newLightOfAMesh_appliesTheSchema() throws Exception {
        read();
        Scene scene = document.scene();
        Light added = Light.of("new", LightType.OBJECT).withArea(light(scene, "bare").area().withShape("plain"));
        var lights = new java.util.ArrayList<>(scene.lights());
        lights.add(added);
        assertThat(export(scene.withLights(lights))).contains("over \"plain\"", "prepend apiSchemas = [\"MeshLightAPI\"]");
    }

    private String export(Scene scene) throws Exception {
        return new String(LightExport.toUsd(document.text(), document.animatedScene().withScene(scene), folder.resolve("shot.jen"),
                folder.resolve("lights.usda")).bytes(), StandardCharsets.UTF_8);
    }
}
