package lightning.render.shading.layer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.material.ShadowCasting;
import lightning.scene.material.Transmission;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;
import org.junit.jupiter.api.Test;

/** Tests the known colors of light that passes through clear shapes. */
class TintedShadowTest {
    private static final Rgb GREEN = new Rgb(0.25, 1, 0.5);
    private static final Rgb ROSE = new Rgb(1, 0.5, 0.75);
    private static final Material WHITE = Material.of("white").withDiffuse(Rgb.WHITE);

    /** A pane of index 1 has no Fresnel reflection. */
    private static Material pane(String name, Rgb clear) {
        return Material.of(name).withDiffuse(Rgb.BLACK)
                .withTransmission(Transmission.NONE.withColor(clear).withIor(1).withThin(true).withShadows(ShadowCasting.TINTED));
    }

    private static Shape square(String name, String material, double y, double size) {
        return new Shape(Solid.PLANE, name, material, new Placement(new Vec3(0, y, 0), Vec3.ZERO, new Vec3(size, 1, size)));
    }

    /** Returns the color of a floor under a sun straight above, seen from below the panes. */
    private static float[] floorColor(List<Material> glass, Light light) {
        List<Shape> shapes = new ArrayList<>(List.of(square("floor", "white", 0, 20)));
        List<Material> materials = new ArrayList<>(List.of(WHITE));
        for (Material m : glass) {
            shapes.add(square("pane " + m.name(), m.name(), 4 + materials.size(), 20));
            materials.add(m);
        }
        return pixel(materials, shapes, light);
    }

    private static float[] pixel(List<Material> materials, List<Shape> shapes, Light light) {
        return new ReferenceTracer(
                new Scene(new PictureSettings(1, 1, 2), new Camera(new Vec3(0.1, 3, 0), Vec3.ZERO, new Vec3(0, 0, -1), 1),
                        new World(1, Rgb.BLACK), materials, List.copyOf(shapes), List.of(light)))
                .pixel(0, 0);
    }

    private static Light sun() {
        return Light.of("sun", LightType.DIRECTIONAL).withDirection(new Vec3(0, -1, 0));
    }

    @Test
    void onePane_tintsShadow() {
        assertThat(floorColor(List.of(pane("green", GREEN)), sun())).containsExactly(0.25f, 1, 0.5f);
    }

    @Test
    void twoPanes_multiplyTints() {
        assertThat(floorColor(List.of(pane("green", GREEN), pane("rose", ROSE)), sun())).containsExactly(0.25f, 0.5f, 0.375f);
    }

    @Test
    void lightBetweenPanes_passesOnlyNearPane() {
        Light bulb = Light.of("bulb", LightType.POINT).withPosition(new Vec3(0, 5.5, 0));
        float[] lit = floorColor(List.of(pane("green", GREEN), pane("rose", ROSE)), bulb);
        assertThat(lit[0] / lit[1]).isCloseTo(0.25f, within(1e-6f));
        assertThat(lit[2] / lit[1]).isCloseTo(0.5f, within(1e-6f));
    }

    @Test
    void fullShadows_blockAndNoShadows_transmit() {
        Material green = pane("green", GREEN);
        assertThat(floorColor(List.of(green.withTransmission(green.transmission().withShadows(ShadowCasting.FULL))), sun()))
                .containsExactly(0, 0, 0);
        assertThat(floorColor(List.of(green.withTransmission(green.transmission().withShadows(ShadowCasting.NONE))), sun()))
                .containsExactly(1, 1, 1);
    }

    @Test
    void opaquePane_castsFullShadow() {
        Material stone = Material.of("stone").withTransmission(Transmission.NONE.withShadows(ShadowCasting.TINTED));
        assertThat(floorColor(List.of(stone), sun())).containsExactly(0, 0, 0);
    }

    /** At normal incidence a surface of index 1.5 mirrors 4 %; a pane has two, and part of the inter-reflections passes. */
    @Test
    void glass_withholdsReflectedLight() {
        Material glass = pane("glass", Rgb.WHITE);
        assertThat(floorColor(List.of(glass.withTransmission(glass.transmission().withIor(1.5))), sun())[0]).isCloseTo(1 - 0.08f / 1.04f,
                within(1e-6f));
        Material mirror = glass.withReflective(new Rgb(0.5, 0, 0));
        assertThat(floorColor(List.of(mirror), sun())).containsExactly(0.5f, 1, 1);
    }

    /** The product passes through all float magnitudes down to 0, never below, and is not NaN next to the brightest light. */
    @Test
    void manyPanes_leaveNoLight() {
        Light brightest = sun().withIntensity(SceneLimits.MAX_INTENSITY);
        float last = Float.POSITIVE_INFINITY;
        for (int n = 1; n < 12; n++) {
            List<Material> glass = new ArrayList<>();
            for (int i = 0; i < n; i++) {
                glass.add(pane("dark " + i, new Rgb(1e-5, 1e-5, 1)));
            }
            float[] lit = floorColor(glass, brightest);
            assertThat(lit[2]).isEqualTo((float) SceneLimits.MAX_INTENSITY);
            assertThat(lit[0]).isBetween(0f, last);
            // Values below float range are invisible.
            assertThat((double) lit[0]).isCloseTo(SceneLimits.MAX_INTENSITY * Math.pow(1e-5, n), within(1e-6 * lit[0] + 1e-14));
            last = lit[0];
        }
        assertThat(last).isZero();
    }

    /** A billion tint distances inside: an almost white tint becomes black, and white stays white in every bit. */
    @Test
    void longPathThroughWhiteTint_staysWhite() {
        Material liquid = Material.of("liquid").withDiffuse(Rgb.BLACK).withTransmission(new Transmission(Rgb.WHITE, 1, false,
                new Rgb(1, 0.999999, 0), 1e-3, ShadowCasting.TINTED));
        Shape ball = new Shape(Solid.SPHERE, "ball", "liquid", new Placement(new Vec3(0, 2e6, 0), Vec3.ZERO, Vec3.ONE.times(1e6)));
        assertThat(pixel(List.of(WHITE, liquid), List.of(square("floor", "white", 0, 20), ball), sun())).containsExactly(1, 0, 0);
    }

    /** Sphere of radius 1 with the shadow ray through its center: 2 units inside. */
    @Test
    void solidBody_tintsByPathLength() {
        Material liquid = Material.of("liquid").withDiffuse(Rgb.BLACK).withTransmission(new Transmission(new Rgb(0.5, 1, 1), 1, false,
                new Rgb(1, 0.5, 0.25), 1, ShadowCasting.TINTED));
        Shape ball = new Shape(Solid.SPHERE, "ball", "liquid", new Placement(new Vec3(0, 6, 0), Vec3.ZERO, Vec3.ONE));
        float[] lit = pixel(List.of(WHITE, liquid), List.of(square("floor", "white", 0, 20), ball), sun());
        assertThat(lit[0]).as("two surfaces").isEqualTo(0.25f);
        assertThat(lit[1]).isCloseTo(0.25f, within(1e-5f));
        assertThat(lit[2]).isCloseTo(0.0625f, within(1e-5f));
        // From a light at its center the ray passes one surface and one unit.
        float[] inside = pixel(List.of(WHITE, liquid), List.of(square("floor", "white", 0, 20), ball),
                Light.of("bulb", LightType.POINT).withPosition(new Vec3(0, 6, 0)));
        assertThat(inside[0]).isCloseTo(0.5f, within(2e-2f));
        assertThat(inside[1] / inside[0]).isCloseTo(1, within(1e-5f));
        assertThat(inside[2] / inside[0]).isCloseTo(0.5f, within(1e-5f));
    }
}
