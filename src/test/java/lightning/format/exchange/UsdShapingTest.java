package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.OptionalDouble;
import java.util.function.UnaryOperator;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ExportedLights;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.sample.PythonPrograms;
import lightning.scene.Scene;
import lightning.scene.light.Beam;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Cones of UsdLux on lights other than spheres; through usd-core. */
class UsdShapingTest {
    private static final String CONE = "float inputs:shaping:cone:angle = 40\nfloat inputs:shaping:cone:softness = 0.3";
    @TempDir
    private Path folder;
    private ImportedScene imported;

    @BeforeEach
    void requireUsd() {
        PythonPrograms.require("pxr");
    }

    private Light imported(String type, String shaping) throws Exception {
        Path stage = Files.writeString(folder.resolve("a.usda"), "#usda 1.0\n(\nstartTimeCode = 1\nendTimeCode = 9\n)\ndef " + type
                + " \"key\" ( prepend apiSchemas = [\"ShapingAPI\"] )\n{\n" + shaping + "\n}\ndef Cube \"cube\" {}\n");
        imported = SceneImporter.read(stage, folder.resolve("a.jen"), LightUnits.CANDELA, Progress.NONE);
        return imported.scene().light("key").orElseThrow();
    }

    private String exported(UnaryOperator<Light> edit) throws Exception {
        imported.write();
        JenDocument document = JenReader.read(folder.resolve("a.jen"));
        Scene scene = document.scene();
        Scene edited = scene.withLights(scene.lights().stream().map(edit).toList());
        return new String(LightExport.toUsd(document.text(), document.animatedScene().withScene(edited), folder.resolve("a.jen"),
                folder.resolve("l.usda")).bytes(), StandardCharsets.UTF_8);
    }

    @ParameterizedTest
    @CsvSource({"CylinderLight, cylinder", "DistantLight, distant"})
    void coneThatALightCannotHave_isNoted(String type, String name) throws Exception {
        imported(type, CONE);
        assertThat(imported.notes()).containsEntry("cones and profiles of " + name + " lights", 1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"RectLight", "CylinderLight", "DistantLight"})
    void editOfAnotherValue_leavesTheConeOfTheStage(String type) throws Exception {
        imported(type, CONE);
        assertThat(exported(light -> light.withIntensity(2 * light.intensity()))).contains("inputs:intensity").doesNotContain("shaping");
    }

    @ParameterizedTest
    @CsvSource({"RectLight, RECT", "DiskLight, DISC"})
    void coneAndFocusOfAFace_areImported(String type, LightType expected) throws Exception {
        Light light = imported(type, CONE + "\nfloat inputs:shaping:focus = 2");
        assertThat(light.type()).isEqualTo(expected);
        assertThat(light.beam()).isEqualTo(new Beam(40, 0.3, Beam.OPEN_ANGLE));
        assertThat(light.dropoff()).isEqualTo(2);
        assertThat(imported.notes().keySet()).noneMatch(note -> note.contains("cone"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"RectLight", "DiskLight"})
    void editedConeAndFocusOfAFace_areWritten(String type) throws Exception {
        imported(type, CONE + "\nfloat inputs:shaping:focus = 2");
        assertThat(exported(light -> light.withBeam(light.beam().withCone(25)))).contains("shaping:cone:angle = 25")
                .doesNotContain("softness", "focus");
        assertThat(exported(light -> light.withBeam(light.beam().withSoftness(0.5)))).contains("shaping:cone:softness = 0.5")
                .doesNotContain("cone:angle", "focus");
        assertThat(exported(light -> light.withDropoff(3))).contains("shaping:focus = 3").doesNotContain("shaping:cone");
    }

    @ParameterizedTest
    @ValueSource(strings = {"RectLight", "DiskLight"})
    void movingConeOfAFace_getsKeys(String type) throws Exception {
        imported(type, "float inputs:shaping:cone:angle.timeSamples = { 1: 20, 9: 60 }");
        assertThat(imported.text()).containsPattern("cone \\{\\s+1 20\\s+9 60");
    }

    /** The schema alone has a cone of 90 degrees, the half space that these lights have anyway. */
    @ParameterizedTest
    @CsvSource({"RectLight, RECT", "DiskLight, DISC"})
    void hardConeOfAHalfSpace_hasNoEffect(String type, LightType expected) throws Exception {
        assertThat(imported(type, "").type()).isEqualTo(expected);
        assertThat(imported.notes().keySet()).noneMatch(note -> note.contains("cones"));
    }

    @Test
    void spotThatBecomesARectangle_losesItsCone() throws Exception {
        assertThat(imported("SphereLight", CONE).type()).isEqualTo(LightType.SPOT);
        assertThat(exported(light -> light.withType(LightType.RECT).withDirection(new Vec3(0, -1, 0))))
                .contains("def RectLight", "shaping:cone:angle = 90", "shaping:cone:softness = 0").doesNotContain("focus");
    }

    @Test
    void editOfAnAnimatedValue_afterAnImportOfOneFrame_isNoted() throws Exception {
        imported("RectLight", "float inputs:intensity.timeSamples = { 1: 1, 9: 2 }");
        Path stage = folder.resolve("a.usda");
        imported = SceneImporter.read(stage, folder.resolve("a.jen"), ImportOptions.DEFAULT.withFrame(OptionalDouble.of(5)),
                Progress.NONE);
        imported.write();
        JenDocument document = JenReader.read(folder.resolve("a.jen"));
        String note = "edited values that the stage animates, written for all frames since one frame was imported";
        for (boolean isAnimated : new boolean[] {true, false}) {
            Scene edited = document.scene().withLights(document.scene().lights().stream()
                    .map(light -> isAnimated ? light.withIntensity(9) : light.withArea(light.area().withWidth(9))).toList());
            ExportedLights export = LightExport.toUsd(document.text(), document.animatedScene().withScene(edited), folder.resolve("a.jen"),
                    folder.resolve("l.usda"));
            assertThat(export.notes().containsKey(note)).isEqualTo(isAnimated);
        }
    }
}
