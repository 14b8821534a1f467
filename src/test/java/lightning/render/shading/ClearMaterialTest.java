package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.image.Film;
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
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Compares refraction through clear shapes with known results: a sphere of radius 1 in front of a wall. */
class ClearMaterialTest {
    private static final Rgb WALL = new Rgb(0.5, 0.25, 1);
    private static final Transmission GLASS = Transmission.NONE.withColor(Rgb.WHITE).withIor(1.5);

    private static Scene scene(int depth, Transmission clarity, Solid solid, List<Light> lights) {
        SceneNode body =
                new Shape(solid, "body", "glass", new Placement(Vec3.ZERO, new Vec3(solid == Solid.PLANE ? 90 : 0, 0, 0), Vec3.ONE));
        SceneNode wall =
                new Shape(Solid.PLANE, "wall", "wall", new Placement(new Vec3(0, 0, -3), new Vec3(90, 0, 0), new Vec3(100, 1, 100)));
        return new Scene(new PictureSettings(33, 33, depth), new Camera(new Vec3(0, 0, 6), Vec3.ZERO, Vec3.Y, 20), new World(1, Rgb.BLACK),
                List.of(Material.of("glass").withDiffuse(Rgb.BLACK).withTransmission(clarity),
                        Material.of("wall").withAmbient(WALL).withDiffuse(lights.isEmpty() ? Rgb.BLACK : Rgb.gray(0.5))),
                List.of(body, wall), lights);
    }

    private static void assertMiddle(Scene scene, double factor) {
        float[] color = new ReferenceTracer(scene).pixel(16, 16);
        assertThat((double) color[0]).isCloseTo(factor * WALL.r(), within(1e-5));
        assertThat((double) color[1]).isCloseTo(factor * WALL.g(), within(1e-5));
        assertThat((double) color[2]).isCloseTo(factor * WALL.b(), within(1e-5));
    }

    /**
     * At normal incidence each face mirrors 4 %. Nothing is in front of the sphere, and inter-reflections leave it after 2, 4 …
     * bounces.
     */
    @ParameterizedTest
    @CsvSource({"0, 0", "1, 0", "2, 0.9216", "3, 0.9216", "4, 0.92307456"})
    void clearSphere_needsTwoBouncesToShowWall(int depth, double factor) {
        assertMiddle(scene(depth, GLASS, Solid.SPHERE, List.of()), factor);
    }

    @Test
    void tint_appliesPerTintDistance() {
        Transmission tinted = GLASS.withTint(Rgb.gray(0.3)).withTintDistance(4);
        assertMiddle(scene(2, tinted, Solid.SPHERE, List.of()), 0.9216 * Math.sqrt(0.3));
    }

    @Test
    void thinPane_neitherRefractsNorTints() {
        Transmission pane = GLASS.withThin(true).withTint(Rgb.BLACK);
        assertMiddle(scene(1, pane, Solid.PLANE, List.of()), 1 - 2 * 0.04 / 1.04);
    }

    @Test
    void halfClearSurface_showsHalfItsBody() {
        Scene scene = scene(1, GLASS.withThin(true).withIor(1).withColor(Rgb.gray(0.5)), Solid.PLANE, List.of());
        Scene lit = scene.withMaterial(scene.material("glass").orElseThrow().withAmbient(WALL));
        assertMiddle(scene, 0.5);
        assertMiddle(lit, 1);
    }

    /** A clear shape with the index of air is invisible, except for rounding. */
    @Test
    void clearBodyWithIorOne_isInvisible() {
        Light light = Light.of("lamp", LightType.POINT).withPosition(new Vec3(3, 3, 4));
        Scene scene = scene(4, GLASS.withIor(1).withShadows(ShadowCasting.NONE), Solid.SPHERE, List.of(light));
        Film film = new ReferenceTracer(scene).trace();
        Film filmOff = new ReferenceTracer(scene.withNodes(scene.nodes().subList(1, 2))).trace();
        for (int i = 0; i < 33 * 33; i++) {
            assertThat(film.red(i % 33, i / 33)).as("pixel " + i).isCloseTo(filmOff.red(i % 33, i / 33), within(1e-5f));
        }
    }

    @Test
    void shadowsNone_transmitsAllLight() {
        Light light = Light.of("lamp", LightType.POINT).withPosition(new Vec3(0, 0, 5));
        float shadowed = new ReferenceTracer(scene(2, GLASS, Solid.SPHERE, List.of(light))).pixel(16, 16)[0];
        float free = new ReferenceTracer(scene(2, GLASS.withShadows(ShadowCasting.NONE), Solid.SPHERE, List.of(light))).pixel(16, 16)[0];
        assertThat((double) shadowed).isCloseTo(0.9216 * WALL.r(), within(1e-5));
        assertThat((double) free).isCloseTo(0.9216 * (WALL.r() + 0.5), within(1e-5));
    }
}
