package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.data.Offset.offset;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.mesh.MeshException;
import lightning.sample.PythonPrograms;
import lightning.scene.NamedCamera;
import lightning.scene.Scene;
import lightning.scene.node.Mesh;
import lightning.scene.node.Solid;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Camera, frame and variants of a stage that an import chooses; through usd-core. */
class UsdChoiceTest {
    private static final ImportOptions PLAIN = ImportOptions.DEFAULT;
    private static final String CAMERAS = """
            def Camera "front" {
                double3 xformOp:translate = (0, 0, 9)
                uniform token[] xformOpOrder = ["xformOp:translate"]
            }
            def Xform "a" {
                def Camera "side" {
                    double3 xformOp:translate = (8, 0, 0)
                uniform token[] xformOpOrder = ["xformOp:translate"]
            }
                def Camera "top" {
                    double3 xformOp:translate = (0, 7, 0)
                uniform token[] xformOpOrder = ["xformOp:translate"]
            }
            }
            def Xform "b" {
                def Camera "top" {
                    double3 xformOp:translate = (0, 6, 0)
                uniform token[] xformOpOrder = ["xformOp:translate"]
            }
            }
            """;
    /** All that a stage can animate, from frame 1001 to 1011. */
    private static final String MOVING = """
            def Camera "eye" {
                double3 xformOp:translate.timeSamples = { 1001: (0, 0, 10), 1011: (0, 0, 20) }
                uniform token[] xformOpOrder = ["xformOp:translate"]
            }
            def SphereLight "lamp" {
                float inputs:intensity.timeSamples = { 1001: 0, 1011: 10 }
            }
            def Mesh "sheet" ( prepend apiSchemas = ["MaterialBindingAPI"] ) {
                int[] faceVertexCounts = [3]
                int[] faceVertexIndices = [0, 1, 2]
                point3f[] points.timeSamples = { 1001: [(0, 0, 0), (1, 0, 0), (0, 1, 0)], 1011: [(0, 0, 0), (3, 0, 0), (0, 1, 0)] }
                uniform token subdivisionScheme = "none"
                rel material:binding = </paint>
            }
            def Sphere "ball" {
                double radius.timeSamples = { 1001: 1, 1011: 3 }
                token visibility.timeSamples = { 1001: "inherited", 1004: "invisible" }
            }
            def Material "paint" {
                token outputs:surface.connect = </paint/s.outputs:surface>
                def Shader "s" {
                    uniform token info:id = "UsdPreviewSurface"
                    color3f inputs:diffuseColor.timeSamples = { 1001: (0, 0, 0), 1011: (1, 0, 0) }
                    token outputs:surface
                }
            }
            """;
    private static final String VARIANTS = """
            def Sphere "ball" ( variants = { string look = "red" }; prepend variantSets = "look" ) {
                variantSet "look" = {
                    "red" {
                        color3f[] primvars:displayColor = [(1, 0, 0)]
                    }
                    "green" {
                        color3f[] primvars:displayColor = [(0, 1, 0)]
                    }
                }
            }
            def Sphere "other" ( variants = { string look = "red" }; prepend variantSets = "look" ) {
                variantSet "look" = {
                    "red" {
                        color3f[] primvars:displayColor = [(1, 0, 0)]
                    }
                    "green" {
                        color3f[] primvars:displayColor = [(0, 0.5, 0)]
                    }
                }
            }
            """;
    @TempDir
    private Path folder;

    @BeforeEach
    void requireUsd() {
        PythonPrograms.require("pxr");
    }

    private ImportedScene imported(String metadata, String prims, ImportOptions options) throws Exception {
        Path file = Files.writeString(folder.resolve("a.usda"), "#usda 1.0\n(\nupAxis = \"Y\"\n" + metadata + ")\n" + prims);
        return SceneImporter.read(file, folder.resolve("a.jen"), options, Progress.NONE);
    }

    private Vec3 eye(String metadata, String prims, String camera) throws Exception {
        return imported(metadata, CAMERAS + prims, PLAIN.withCamera(camera)).scene().camera().from();
    }

    @Test
    void camera_isChosenByNameOrPath() throws Exception {
        assertThat(eye("", "", "side")).isEqualTo(new Vec3(8, 0, 0));
        assertThat(eye("", "", "/b/top")).isEqualTo(new Vec3(0, 6, 0));
    }

    @Test
    void cameraOfRenderSettings_isTheDefault() throws Exception {
        String settings = "def RenderSettings \"settings\" {\nrel camera = </a/side>\n}\n";
        assertThat(eye("", "", "")).isEqualTo(new Vec3(0, 0, 9));
        assertThat(eye("renderSettingsPrimPath = \"/settings\"\n", settings, "")).isEqualTo(new Vec3(8, 0, 0));
        assertThat(eye("renderSettingsPrimPath = \"/settings\"\n", settings, "front")).isEqualTo(new Vec3(0, 0, 9));
    }

    @Test
    void missingCameraOfRenderSettings_isNoted() throws Exception {
        assertThat(imported("renderSettingsPrimPath = \"/settings\"\n",
                CAMERAS + "def RenderSettings \"settings\" {\nrel camera = </gone>\n}\n", PLAIN).notes())
                .containsEntry("cameras of render settings that the stage does not have: /gone", 1);
    }

    @Test
    void allCameras_areKeptUnderTheirNames() throws Exception {
        Scene scene = imported("", CAMERAS, PLAIN).scene();
        assertThat(scene.cameras()).extracting(NamedCamera::name).containsExactly("front", "side", "top", "top 2");
        assertThat(scene.cameras().getFirst().camera()).isEqualTo(scene.camera());
        assertThat(scene.cameras().getLast().camera().from()).isEqualTo(new Vec3(0, 6, 0));
    }

    @Test
    void unknownCamera_isRejectedWithThePaths() {
        assertThatThrownBy(() -> imported("", CAMERAS, PLAIN.withCamera("no"))).isInstanceOf(MeshException.class)
                .hasMessageEndingWith("must have the camera 'no', has '/front', '/a/side', '/a/top', '/b/top'");
        assertThatThrownBy(() -> imported("", CAMERAS, PLAIN.withCamera("top"))).isInstanceOf(MeshException.class)
                .hasMessageEndingWith("must have only one camera 'top', has '/a/top', '/b/top'");
        assertThatThrownBy(() -> imported("", "", PLAIN.withCamera("no"))).isInstanceOf(MeshException.class)
                .hasMessageEndingWith("must have the camera 'no', has none");
    }

    @Test
    void frame_isThatOfTheWholeStage() throws Exception {
        ImportedScene imported = imported("startTimeCode = 1001\nendTimeCode = 1011\n", MOVING, PLAIN.withFrame(OptionalDouble.of(1006)));
        Scene scene = imported.scene();
        assertThat(imported.shot()).isEmpty();
        assertThat(scene.camera().from()).isEqualTo(new Vec3(0, 0, 15));
        assertThat(scene.lights().getFirst().intensity()).isCloseTo(5, offset(1e-6));
        Mesh sheet = ((Solid.TriangleMesh) scene.placedShapes().getFirst().shape().solid()).mesh();
        assertThat(sheet.positions()).contains(2f).doesNotContain(1.5f, 3f);
        assertThat(scene.placedShapes().getFirst().material().base()).isEqualTo(new Rgb(0.5, 0, 0));
        assertThat(scene.stage().node("ball").orElseThrow().visible()).isFalse();
        assertThat(scene.stage().node("ball").orElseThrow().placement().scale().x()).isCloseTo(2, offset(1e-9));
        assertThat(imported.notes().keySet()).noneMatch(note -> note.contains("frame"));
    }

    @Test
    void frameBetweenFrames_isInterpolated() throws Exception {
        assertThat(imported("", MOVING, PLAIN.withFrame(OptionalDouble.of(1001.5))).scene().camera().from().z())
                .isCloseTo(10.5, offset(1e-6));
    }

    @Test
    void frameOutsideTheStage_isNoted() throws Exception {
        assertThat(imported("startTimeCode = 1001\nendTimeCode = 1011\n", MOVING, PLAIN.withFrame(OptionalDouble.of(5))).notes())
                .containsEntry("frames outside of the stage's 1001 to 1011", 1);
    }

    @Test
    void animation_notesWhatKeepsItsFirstFrame() throws Exception {
        ImportedScene imported = imported("startTimeCode = 1001\nendTimeCode = 1011\n", MOVING, PLAIN);
        assertThat(imported.shot()).isPresent();
        assertThat(imported.notes()).containsEntry("deforming meshes, as at the first frame (1001): '/sheet'", 1)
                .containsEntry("objects whose size changes, as at the first frame (1001): '/ball'", 1)
                .containsEntry("animated inputs of materials, as at the first frame (1001): '/paint/s.inputs:diffuseColor'", 1);
    }

    private static List<Rgb> colors(ImportedScene imported) {
        return imported.scene().placedShapes().stream().map(shape -> shape.material().diffuse()).toList();
    }

    @Test
    void variant_isSelectedOnAllPrimsOrOnOne() throws Exception {
        assertThat(colors(imported("", VARIANTS, PLAIN))).containsExactly(new Rgb(1, 0, 0), new Rgb(1, 0, 0));
        assertThat(colors(imported("", VARIANTS, PLAIN.withVariants(List.of("look=green")))))
                .containsExactly(new Rgb(0, 1, 0), new Rgb(0, 0.5, 0));
        assertThat(colors(imported("", VARIANTS, PLAIN.withVariants(List.of("/other:look=green")))))
                .containsExactly(new Rgb(1, 0, 0), new Rgb(0, 0.5, 0));
    }

    @Test
    void variantInsideAnInstance_isSelected() throws Exception {
        String car = "def Xform \"car\" {\n" + VARIANTS + "}\n"
                + "def Xform \"copy\" (\ninstanceable = true\nprepend references = </car>\n) {}\n";
        assertThat(colors(imported("", car, PLAIN.withVariants(List.of("look=green"))))).containsExactly(new Rgb(0, 1, 0),
                new Rgb(0, 0.5, 0), new Rgb(0, 1, 0), new Rgb(0, 0.5, 0));
    }

    @Test
    void variantSetsWithoutAChoice_areNoted() throws Exception {
        assertThat(imported("", VARIANTS, PLAIN).notes()).containsEntry("variants, imported as the stage selects them: look (green, red)",
                1);
        assertThat(imported("", VARIANTS, PLAIN.withVariants(List.of("look=red"))).notes().keySet())
                .noneMatch(note -> note.contains("variant"));
    }

    @Test
    void unknownVariant_isRejectedWithTheNames() {
        assertThatThrownBy(() -> imported("", VARIANTS, PLAIN.withVariants(List.of("look=blue")))).isInstanceOf(MeshException.class)
                .hasMessageEndingWith("must have the variant 'blue' of 'look', has 'green', 'red'");
        assertThatThrownBy(() -> imported("", VARIANTS, PLAIN.withVariants(List.of("size=big")))).isInstanceOf(MeshException.class)
                .hasMessageEndingWith("must have the variant set 'size', has 'look'");
        assertThatThrownBy(() -> imported("", VARIANTS, PLAIN.withVariants(List.of("/none:look=red")))).isInstanceOf(MeshException.class)
                .hasMessageEndingWith(": must have the prim /none for the variant 'look=red'");
        assertThatThrownBy(() -> imported("", VARIANTS, PLAIN.withVariants(List.of("green")))).isInstanceOf(MeshException.class)
                .hasMessageEndingWith("must have a variant such as 'look=red', not 'green'");
    }
}
