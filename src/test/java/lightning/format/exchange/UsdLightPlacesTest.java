package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ExportedLights;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.sample.PythonPrograms;
import lightning.scene.light.Light;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Lights of a stage that are scaled, unknown or in instances; through usd-core. */
class UsdLightPlacesTest {
    @TempDir
    private Path folder;

    @BeforeEach
    void requireUsd() {
        PythonPrograms.require("pxr");
    }

    private ImportedScene imported(String prims) throws Exception {
        Path stage = Files.writeString(folder.resolve("a.usda"), "#usda 1.0\n(\n    upAxis = \"Y\"\n)\ndef Cube \"cube\"\n{\n}\n" + prims);
        ImportedScene scene = SceneImporter.read(stage, folder.resolve("a.jen"), LightUnits.CANDELA, Progress.NONE);
        scene.write();
        return scene;
    }

    private double radius(String type, String scale) throws Exception {
        return imported("def " + type + " \"key\" {\nfloat inputs:radius = 20\nfloat inputs:length = 30\nfloat3 xformOp:scale = " + scale
                + "\nuniform token[] xformOpOrder = [\"xformOp:scale\"]\n}\n").scene().light("key").orElseThrow().area().radius();
    }

    /** The power is the luminance times the area, so the areas have to be equal. */
    @Test
    void ellipses_keepTheirArea() throws Exception {
        // An ellipse has the area π·a·b.
        assertThat(radius("DiskLight", "(2, 0.5, 1)")).isCloseTo(Math.sqrt(40 * 10), offset(1e-8));
        assertThat(radius("DiskLight", "(2, 1, 1)")).isCloseTo(Math.sqrt(40 * 20), offset(1e-8));
        // A prolate spheroid of half axes a, a, c has 2π·a²·(1 + c / (a·e) · asin e).
        double e = Math.sqrt(1 - 1.0 / 9);
        double surface = 2 * Math.PI * 400 * (1 + 3 / e * Math.asin(e));
        assertThat(radius("SphereLight", "(1, 1, 3)")).isCloseTo(Math.sqrt(surface / (4 * Math.PI)), offset(1e-3));
        assertThat(radius("SphereLight", "(3, 1, 1)")).isCloseTo(Math.sqrt(surface / (4 * Math.PI)), offset(1e-3));
        assertThat(radius("SphereLight", "(2, 2, 2)")).isEqualTo(40);
        assertThat(
                imported(
                        "def SphereLight \"key\" {\nfloat3 xformOp:scale = (1, 1, 3)\nuniform token[] xformOpOrder = [\"xformOp:scale\"]\n}")
                        .notes())
                .containsEntry("round lights scaled to ellipses, imported as round ones of the same area", 1);
    }

    @Test
    void unknownLights_areNotedByName() throws Exception {
        assertThat(imported("""
                def AcmeSoftLight "acme"
                {
                }
                def PluginLight "plug"
                {
                }
                def Xform "group" ( prepend apiSchemas = ["LightAPI"] )
                {
                }
                """).notes().keySet()).anyMatch(note -> note.startsWith("/acme: is a light of the unknown type AcmeSoftLight"))
                .anyMatch(note -> note.startsWith("/plug: is a light of the unknown type PluginLight"))
                .anyMatch(note -> note.startsWith("/group: is a light of the unknown type Xform"));
    }

    @Test
    void lightsOfPointInstancers_areAtEachPlace() throws Exception {
        ImportedScene scene = imported("""
                def PointInstancer "rows"
                {
                    int[] protoIndices = [0, 0, 0]
                    point3f[] positions = [(10, 0, 0), (20, 0, 0), (30, 0, 0)]
                    rel prototypes = [</rows/lamp>]
                    double3 xformOp:translate = (0, 100, 0)
                    uniform token[] xformOpOrder = ["xformOp:translate"]

                    def Xform "lamp"
                    {
                        double3 xformOp:translate = (0, 0, 5)
                        uniform token[] xformOpOrder = ["xformOp:translate"]

                        def SphereLight "bulb"
                        {
                            double3 xformOp:translate = (1, 0, 0)
                            uniform token[] xformOpOrder = ["xformOp:translate"]
                        }
                    }
                }
                """);
        assertThat(scene.scene().lights().stream().map(Light::position)).containsExactly(new Vec3(11, 100, 5), new Vec3(21, 100, 5),
                new Vec3(31, 100, 5));
        JenDocument document = JenReader.read(folder.resolve("a.jen"));
        List<Light> brighter = document.scene().lights().stream().map(l -> l.withIntensity(9)).toList();
        ExportedLights same =
                LightExport.toUsd(document.text(), document.animatedScene(), folder.resolve("a.jen"), folder.resolve("l.usda"));
        ExportedLights export = LightExport.toUsd(document.text(),
                document.animatedScene().withScene(document.scene().withLights(brighter)), folder.resolve("a.jen"),
                folder.resolve("l.usda"));
        assertThat(new String(same.bytes(), StandardCharsets.UTF_8)).doesNotContain("rows", "lightning_lights");
        assertThat(same.notes()).isEmpty();
        assertThat(new String(export.bytes(), StandardCharsets.UTF_8)).doesNotContain("rows", "lightning_lights");
        assertThat(export.notes()).containsEntry("edited lights of point instancers, which a layer cannot change one by one", 3);
    }

    /** Prototypes are usually kept under an invisible prim. */
    @Test
    void lightsOfHiddenPrototypes_shine() throws Exception {
        ImportedScene scene = imported("""
                def Scope "protos"
                {
                    token visibility = "invisible"
                    def Xform "lamp"
                    {
                        def SphereLight "bulb"
                        {
                        }
                        def SphereLight "spare"
                        {
                            token visibility = "invisible"
                        }
                    }
                }
                def PointInstancer "rows"
                {
                    int[] protoIndices = [0]
                    point3f[] positions = [(10, 0, 0)]
                    rel prototypes = [</protos/lamp>]
                }
                """);
        assertThat(scene.scene().lights().stream().filter(Light::on).map(Light::position)).containsExactly(new Vec3(10, 0, 0));
        assertThat(scene.scene().lights()).hasSize(4);
    }
}
