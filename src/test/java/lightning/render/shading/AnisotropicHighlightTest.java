package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Anisotropy;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests anisotropic highlights at a surface with normal y and tangent x against formulas and integrals. */
class AnisotropicHighlightTest {
    private static final float[] TANGENT = {1, 0, 0};
    private static final int STEPS = 500;

    private static AnisotropicHighlight highlight(double strength, double rotation) {
        return AnisotropicHighlight
                .of(Material.of("m").withModel(ShadingModel.PRINCIPLED).withAnisotropy(new Anisotropy(strength, rotation)));
    }

    private static LightingEquation lit(Vec3 from) {
        Light light = Light.of("l", LightType.DIRECTIONAL).withDirection(from.times(-1));
        Scene scene = new Scene(PictureSettings.DEFAULT, new Camera(Vec3.ZERO, new Vec3(0, 0, -1), Vec3.Y, 40), World.DEFAULT, List.of(),
                List.of(), List.of(light));
        var equation = new LightingEquation(LightSource.of(light, scene));
        equation.moveTo(0, 0, 0, 0, 1, 0);
        return equation;
    }

    /** Returns N·L·D·V of a light in a direction, seen from another. */
    private static double term(Vec3 light, Vec3 view, AnisotropicHighlight highlight, double alpha) {
        LightingEquation equation = lit(light);
        float vx = (float) -view.x();
        float vy = (float) -view.y();
        float vz = (float) -view.z();
        return equation.anisotropicFacets(0, 1, 0, vx, vy, vz, TANGENT, highlight, alpha);
    }

    @Test
    void headOnHighlight_isQuarterOfInverseProductOfWidths() {
        // D = 1/(α∥·α⊥), V = 1/4; Burley's widths are α/aspect and α·aspect.
        assertThat(term(Vec3.Y, Vec3.Y, highlight(0.8, 30), 0.25)).isCloseTo(1 / (4 * 0.0625), within(1e-5));
    }

    @ParameterizedTest
    @CsvSource({"0.5, 0, 0.25", "0.8, 90, 0.2", "1, 40, 0.3"})
    void distribution_coversTheSurfaceOnce(double strength, double rotation, double alpha) {
        // ∫ D·cos over the half-vectors is 1. Seen along the normal, a light in direction L has D·cos·4·cos dH = D·cos dL.
        double sum = 0;
        for (int i = 0; i < STEPS; i++) {
            double cosine = (i + 0.5) / STEPS;
            double radius = Math.sqrt(1 - cosine * cosine);
            for (int j = 0; j < STEPS / 4; j++) {
                double angle = 8 * Math.PI * (j + 0.5) / STEPS;
                Vec3 half = new Vec3(radius * Math.cos(angle), cosine, radius * Math.sin(angle));
                sum += distribution(half, strength, rotation, alpha) * cosine / (STEPS * (double) STEPS / 4);
            }
        }
        // D lacks its 1/π, and the sum lacks the 2π of the hemisphere.
        assertThat(2 * sum).isCloseTo(1, within(0.01));
    }

    /** Returns D from the term of a light that is where the viewer is: there H is its direction, and V = 1/(g·g). */
    private static double distribution(Vec3 half, double strength, double rotation, double alpha) {
        AnisotropicHighlight highlight = highlight(strength, rotation);
        double angle = Math.toRadians(rotation);
        // X is x turned toward Y = N × X = −z.
        double x = half.x() * Math.cos(angle) - half.z() * Math.sin(angle);
        double y = -half.x() * Math.sin(angle) - half.z() * Math.cos(angle);
        double aspect = Math.sqrt(1 - 0.9 * strength);
        double along = Math.min(1, alpha / aspect);
        double across = alpha * aspect;
        double g = half.y() + Math.sqrt(along * along * x * x + across * across * y * y + half.y() * half.y());
        return term(half, half, highlight, alpha) * g * g / half.y();
    }

    @Test
    void noStrength_isTheIsotropicTerm() {
        Vec3 light = new Vec3(0.3, 0.8, 0.2).normalized();
        Vec3 view = new Vec3(-0.4, 0.6, 0.5).normalized();
        LightingEquation equation = lit(light);
        double isotropic = (double) equation.metallicSpecular(0, 1, 0, (float) -view.x(), (float) -view.y(), (float) -view.z(), 0.2)
                + equation.metallicGrazing(0, 1, 0, (float) -view.x(), (float) -view.y(), (float) -view.z(), 0.2);
        assertThat(term(light, view, highlight(1e-9, 20), 0.2)).isCloseTo(isotropic, within(1e-6 * isotropic));
    }

    @Test
    void halfTurn_changesNothing() {
        Vec3 light = new Vec3(0.3, 0.8, 0.2).normalized();
        Vec3 view = new Vec3(-0.4, 0.6, 0.5).normalized();
        assertThat(term(light, view, highlight(0.7, 200), 0.2)).isCloseTo(term(light, view, highlight(0.7, 20), 0.2), within(1e-6));
    }

    @Test
    void highlight_isLongerAlongTheTangent() {
        Vec3 aside = new Vec3(0.5, 0.8, 0).normalized();
        Vec3 across = new Vec3(0, 0.8, 0.5).normalized();
        assertThat(term(aside, Vec3.Y, highlight(0.8, 0), 0.1)).isGreaterThan(5 * term(across, Vec3.Y, highlight(0.8, 0), 0.1));
        assertThat(term(aside, Vec3.Y, highlight(0.8, 90), 0.1)).isCloseTo(term(across, Vec3.Y, highlight(0.8, 0), 0.1), within(1e-6));
    }

    @Test
    void rotation_isCounterclockwiseSeenByTheViewer() {
        // Seen from y, with x to the right, −z is up.
        Vec3 left = new Vec3(0.5, 0.8, -0.5).normalized();
        Vec3 right = new Vec3(0.5, 0.8, 0.5).normalized();
        assertThat(term(left, Vec3.Y, highlight(0.8, 45), 0.1)).isGreaterThan(5 * term(right, Vec3.Y, highlight(0.8, 45), 0.1));
    }

    @Test
    void smallestRoughness_hasFiniteBoundedTerms() {
        Material steel = Material.of("m").withModel(ShadingModel.PRINCIPLED).withRoughness(0.08).withAnisotropy(new Anisotropy(1, 0));
        double largest = term(Vec3.Y, Vec3.Y, highlight(1, 0), steel.alpha());
        assertThat(largest).isLessThan(steel.maxTerm());
    }
}
