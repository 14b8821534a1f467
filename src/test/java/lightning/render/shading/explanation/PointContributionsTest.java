package lightning.render.shading.explanation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import lightning.format.jen.JenWriter;
import lightning.sample.SceneArbitraries;
import lightning.scene.Scene;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

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
            PointReport report =
                    explainer.explainPixel(pixels.nextInt(scene.picture().width()), pixels.nextInt(scene.picture().height()));
            if (report.isBackground()) {
                continue;
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
}
