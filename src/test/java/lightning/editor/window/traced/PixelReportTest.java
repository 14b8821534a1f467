package lightning.editor.window.traced;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import lightning.base.math.Vec3;
import lightning.render.shading.explanation.LightReport;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;

/** Texts of the pixel report. */
class PixelReportTest {
    private static LightReport light(String name, LightReport.State state, float diffuse) {
        return new LightReport(Light.of(name, LightType.DIRECTIONAL), state, -1, 1, 1, 1, 0, 1, 0, 0, 1,
                new float[] {diffuse, diffuse, diffuse}, new float[3], new float[3], new float[] {1, 1, 1}, new float[] {1, 1, 1}, 1);
    }

    private static PixelReport report(List<LightReport> lights, List<LightReport> environmentLights) {
        return new PixelReport(3, 4, "ball", "", Vec3.ZERO, new Vec3(0, 1, 0), null, lights, environmentLights, null);
    }

    @Test
    void environmentLights_areOneLine() {
        List<LightReport> sky = new ArrayList<>();
        IntStream.range(0, 48).forEach(i -> sky.add(light("environment " + i, i < 12 ? LightReport.State.LIT : LightReport.State.SHADOWED,
                i < 12 ? 0.0625f : 0)));
        var report = report(List.of(light("key", LightReport.State.LIT, 2.25f), light("rim", LightReport.State.AWAY, 0)), sky);
        assertThat(report.lightLines()).containsExactly("key  75 %", "rim  backfacing",
                "environment  25 %, 12 of its 48 bright parts are visible");
    }

    @Test
    void indirectLight_isTheLastLine() {
        var report =
                new PixelReport(3, 4, "ball", "", Vec3.ZERO, new Vec3(0, 1, 0), null, List.of(light("key", LightReport.State.LIT, 0.75f)),
                        List.of(), new float[] {0.25f, 0.25f, 0.25f});
        assertThat(report.lightLines()).containsExactly("key  75 %", "indirect light  25 %");
    }

    @Test
    void withoutEnvironment_hasNoEnvironmentLine() {
        assertThat(report(List.of(light("key", LightReport.State.LIT, 1)), List.of()).lightLines()).containsExactly("key  100 %");
    }

    @Test
    void mappedNormal_isReportedWithGeometricNormal() {
        assertThat(report(List.of(), List.of()).headline("1 2 3").lines()).containsExactly("3, 4  ball  normal 0.00 1.00 0.00", "1 2 3");
        var bumpy = new PixelReport(3, 4, "ball", "", Vec3.ZERO, new Vec3(0.6, 0.8, 0), new Vec3(0, 1, 0), List.of(), List.of(), null);
        assertThat(bumpy.headline("").lines())
                .containsExactly("3, 4  ball  normal 0.60 0.80 0.00, geometric normal 0.00 1.00 0.00", " ");
    }

    /** A click selects the strongest light. */
    @Test
    void faceOfALight_selectsIt() {
        var face = new PixelReport(3, 4, "", "lamp", Vec3.ZERO, new Vec3(0, 1, 0), null, List.of(light("key", LightReport.State.LIT, 0)),
                List.of(), null);
        assertThat(face.strongest()).contains("lamp");
        assertThat(face.headline("").lines().findFirst().orElseThrow()).startsWith("3, 4  light lamp  normal");
    }

    @Test
    void lightBelowSurface_isReported() {
        var light =
                new LightReport(Light.of("key", LightType.POINT), LightReport.State.SHADOWED, 0, 0, 1, 1, 1, 0.5f, 0, 0, 0, new float[3],
                        new float[3], new float[3], new float[] {1, 1, 1}, new float[] {1, 1, 1}, 1);
        assertThat(report(List.of(light), List.of()).lightLines()).containsExactly("key  below the horizon");
    }

    @Test
    void strongestLight_isSelectable() {
        var report = report(List.of(light("key", LightReport.State.LIT, 0.1f)), List.of(light("environment 1", LightReport.State.LIT, 9)));
        assertThat(report.strongest()).contains("key");
    }
}
