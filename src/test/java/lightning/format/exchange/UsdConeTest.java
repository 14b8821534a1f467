package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import lightning.base.work.Progress;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.sample.PythonPrograms;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Soft cones of stages, through usd-core. */
class UsdConeTest {
    private static final String SPOT = """
            def SphereLight "%s" ( prepend apiSchemas = ["ShapingAPI"] )
            {
                float inputs:shaping:cone:angle = %s
                float inputs:shaping:cone:softness%s
            }
            """;
    @TempDir
    private Path folder;
    private ImportedScene imported;

    @BeforeEach
    void requireUsd() {
        PythonPrograms.require("pxr");
    }

    private JenDocument imported(String lights) throws Exception {
        Path stage = Files.writeString(folder.resolve("a.usda"),
                "#usda 1.0\n(\n    startTimeCode = 1\n    endTimeCode = 4\n)\ndef Cube \"cube\"\n{\n}\n" + lights);
        imported = SceneImporter.read(stage, folder.resolve("a.jen"), LightUnits.CANDELA, Progress.NONE);
        imported.write();
        return JenReader.read(folder.resolve("a.jen"));
    }

    private String exported(JenDocument document, Scene scene) throws IOException {
        return exported(document.text(), document, scene);
    }

    /** Exports all values, as of a scene that an earlier version imported. */
    private String exportedWhole(JenDocument document, Scene scene) throws IOException {
        return exported(String.join("\n", document.text().lines().filter(s -> !s.startsWith("# usd values: ")).toList()), document, scene);
    }

    private String exported(String text, JenDocument document, Scene scene) throws IOException {
        return new String(LightExport.toUsd(text, document.animatedScene().withScene(scene), folder.resolve("a.jen"),
                folder.resolve("l.usda")).bytes(), StandardCharsets.UTF_8);
    }

    @Test
    void softness_isSmoothCurve() throws Exception {
        for (double angle : List.of(40.0, 90.0, 120.0)) {
            for (double softness : List.of(0.25, 1.0)) {
                Light light = imported(String.format(Locale.ROOT, SPOT, "key", angle, " = " + softness)).scene().light("key").orElseThrow();
                assertThat(light.angle()).isEqualTo(angle);
                for (double degrees = 0; degrees < 180; degrees += 0.37) {
                    double t = Math.clamp((degrees - angle * (1 - softness)) / (angle * softness), 0, 1);
                    assertThat(light.profile().orElseThrow().photometry().sample(degrees, 30)).as("at %s", degrees)
                            .isCloseTo(1 - t * t * (3 - 2 * t), offset(2e-4));
                }
            }
        }
        assertThat(imported.notes().keySet()).noneMatch(note -> note.contains("soft"));
    }

    @Test
    void softness_comesBack() throws Exception {
        JenDocument document =
                imported(String.format(Locale.ROOT, SPOT, "key", 40, " = 0.3") + String.format(Locale.ROOT, SPOT, "fill", 40, " = 0.3")
                        + String.format(Locale.ROOT, SPOT, "rim", 35.5, " = 0"));
        Scene scene = document.scene();
        assertThat(scene.light("key").orElseThrow().profile()).isEqualTo(scene.light("fill").orElseThrow().profile());
        String layer = exportedWhole(document, scene);
        assertThat(layer).contains("cone:softness = 0.3").contains("cone:angle = 40").doesNotContain(".ies");
        // With another angle, the cone is no longer one of UsdLux.
        String narrowed = exported(document, scene.withLights(scene.lights().stream().map(l -> l.withAngle(20)).toList()));
        assertThat(narrowed).contains("cone 40 soft 0.3.ies", "cone:softness = 0\n", "cone:angle = 20")
                .doesNotContain("cone:softness = 0.3");
    }

    @Test
    void movingCone_isHard() throws Exception {
        Light light = imported(String.format(Locale.ROOT, SPOT, "key", 40, ".timeSamples = { 1: 0.5, 4: 0.5001 }")).scene().light("key")
                .orElseThrow();
        assertThat(light.profile()).isEmpty();
        assertThat(light.angle()).isEqualTo(30);
        assertThat(imported.notes().keySet()).anyMatch(note -> note.startsWith("soft edges of cones"));
    }
}
