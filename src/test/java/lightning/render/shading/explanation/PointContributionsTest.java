package lightning.render.shading.explanation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.Random;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.format.jen.JenWriter;
import lightning.sample.SceneArbitraries;
import lightning.scene.Scene;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

class PointContributionsTest {
    @Provide
    Arbitrary<Scene> scenes() {
        return SceneArbitraries.scenes();
    }

    /** All parts are at least 0, so that their sum differs from the color by roundings only. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    void parts_sumToTheColor(@ForAll("scenes") Scene scene, @ForAll Random pixels) {
        var explainer = new PixelExplainer(scene);
        for (int i = 0; i < 30; i++) {
            checkSum(scene, explainer, pixels.nextInt(scene.picture().width()), pixels.nextInt(scene.picture().height()));
        }
    }

    /** A path through the solid leaves so little light that a product of weights loses its precision, and the ambient color is the largest. */
    @Test
    void brightLightThroughDarkGlass_partsSumToTheColor() throws JenException {
        Scene scene = JenReader.read("""
                jen 1
                picture { size 14 8 depth 0 }
                camera { from -3 0.5 7 }
                world { ambience 0.05 }
                material glass {
                  ambient 1000000 1000000 1000000
                  model metallic base 0 0 0 roughness 0 f0 0
                  clear 0 0 0.05 ior 1 tint 0 0 0.5522843392915492 tint_distance 0.1
                }
                sphere shell { material glass scale 12 11 13 }
                """, "glass", Path.of("")).scene();
        var explainer = new PixelExplainer(scene);
        for (int y = 0; y < scene.picture().height(); y++) {
            for (int x = 0; x < scene.picture().width(); x++) {
                checkSum(scene, explainer, x, y);
            }
        }
    }

    private static void checkSum(Scene scene, PixelExplainer explainer, int x, int y) {
        PointReport report = explainer.explainPixel(x, y);
        if (report.isBackground()) {
            return;
        }
        var parts = PointContributions.of(explainer.geometry().material(report.hit().primitive()), report.hit());
        for (int c = 0; c < 3; c++) {
            double sum = (double) report.ambient()[c] + report.glow()[c];
            for (LightReport light : report.lights()) {
                sum += parts.ofLight(light)[c];
            }
            sum += report.reflected() == null ? 0 : parts.reflectedPart(report.reflected().color())[c];
            sum += report.refracted() == null ? 0 : parts.refractedPart(report.refracted().color())[c];
            double color = report.color()[c];
            // Each of n additions and of at most 16 steps of a part loses at most half a unit; products below the smallest normal
            // float lose at most 2⁻¹⁵⁰ each.
            assertThat(sum).as(JenWriter.write(scene)).isCloseTo(color,
                    within((report.lights().size() + 20) * 0x1p-23 * color + 0x1p-140));
        }
    }
}
