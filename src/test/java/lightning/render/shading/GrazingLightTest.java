package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import lightning.base.math.Ray;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.image.Film;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.render.trace.BruteForce;
import lightning.render.trace.Geometry;
import lightning.render.trace.PixelRays;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that grazing light causes neither bands nor speckles, and that a light at distance 0 is not brighter than a near one. */
class GrazingLightTest {
    private static final Material WHITE = Material.of("white").withDiffuse(Rgb.WHITE).withShininess(1);

    private static Scene scene(SceneNode node, Camera camera, Light light) {
        return scene(WHITE, node, camera, light);
    }

    private static Scene scene(Material white, SceneNode node, Camera camera, Light light) {
        return new Scene(new PictureSettings(48, 40, 0), camera, World.DEFAULT, List.of(white), List.of(node), List.of(light));
    }

    private static SceneNode floor(Vec3 at, Vec3 rotate) {
        return new Shape(Solid.PLANE, "floor", "white", new Placement(at, rotate, new Vec3(1e4, 1, 1e4)));
    }

    private static Light sun(double cosine) {
        return Light.of("sun", LightType.DIRECTIONAL)
                .withDirection(new Vec3(-0.6 * Math.sqrt(1 - cosine * cosine), -cosine, -0.8 * Math.sqrt(1 - cosine * cosine)));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 0.5, 1e-2, 1e-4, 1e-6, 1e-9, 1e-12, -1e-12, -1e-9, -1e-6, -1e-2, -1})
    void levelFloor_hasUniformColor(double cosine) {
        Camera camera = new Camera(new Vec3(0, 1, 0), new Vec3(3, -4, -4), Vec3.Y, 30);
        Film film = new ReferenceTracer(scene(floor(Vec3.ZERO, Vec3.ZERO), camera, sun(cosine))).trace();
        for (float value : film.toScanlines()) {
            assertThat((double) value).isBetween(Math.max(cosine, 0) * (1 - 0x1p-22), Math.max(cosine, 0) * (1 + 0x1p-22));
        }
    }

    /** N·L is exactly 0: the mirror direction is along the floor, and there must be no highlight. */
    @Test
    void lightAtHorizon_hasNoHighlight() {
        Material shiny = Material.of("white").withDiffuse(Rgb.WHITE).withSpecular(Rgb.WHITE).withShininess(1);
        Light sun = Light.of("sun", LightType.DIRECTIONAL).withDirection(new Vec3(0, 0, 1));
        Camera camera = new Camera(new Vec3(0, 1, 0), new Vec3(0, 0.9, -1), Vec3.Y, 5);
        Scene scene = scene(shiny, floor(Vec3.ZERO, Vec3.ZERO), camera, sun);
        assertThat(new ReferenceTracer(scene).trace().toScanlines()).containsOnly(0);
        assertThat(new ReferenceTracer(scene.withLight(sun.withDirection(new Vec3(0, -1e-3, 1)))).pixel(24, 20)[0]).isGreaterThan(0.9f);
    }

    /** The normal of a tilted floor is rounded; lights above that error reach all of it. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 0.1, 1e-3, 1e-5, 1e-6, -1e-6, -0.1})
    void tiltedFloor_hasUniformColor(double cosine) {
        SceneNode floor = floor(new Vec3(0, -5, 0), new Vec3(11, 23, 7));
        Vec3 normal = floor.placement().transform().transformVector(Vec3.Y).normalized();
        Vec3 along = normal.cross(new Vec3(0.3, 0.2, -1)).normalized();
        Light sun = Light.of("sun", LightType.DIRECTIONAL)
                .withDirection(along.plus(normal.times(cosine / Math.sqrt(1 - Math.min(0.999, cosine * cosine)))).negated());
        Film film = new ReferenceTracer(scene(floor, new Camera(Vec3.ZERO, new Vec3(1, -3, -5), Vec3.Y, 30), sun)).trace();
        float[] values = film.toScanlines();
        for (float value : values) {
            assertThat(value).isEqualTo(values[0]);
        }
        assertThat(values[0] > 0).isEqualTo(cosine > 0);
    }

    /** Every pixel of a sphere is as bright as the cosine of its own normal: no shadow speckle on the lit side. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1e-3, 1e4})
    void sphereUnderDirectionalLight_dependsOnlyOnNormal(double scale) {
        Vec3 at = new Vec3(3, 1, -5).times(scale);
        Scene scene = scene(new Shape(Solid.SPHERE, "ball", "white", new Placement(at, Vec3.ZERO, Vec3.ONE.times(scale))),
                new Camera(Vec3.ZERO, at, Vec3.Y, 20), sun(0.3));
        Film film = new ReferenceTracer(scene).trace();
        Vec3 toSun = scene.lights().getFirst().direction().normalized().negated();
        Geometry geometry = Geometry.of(scene);
        int lit = 0;
        for (int y = 0; y < film.height(); y++) {
            for (int x = 0; x < film.width(); x++) {
                Ray ray = new PixelRays(scene).ray(x, y);
                if (BruteForce.nearest(geometry, ray) == 0) {
                    Vec3 normal = ray.direction().times(geometry.distance(0, ray)).minus(at).normalized();
                    double expected = Math.max(normal.dot(toSun), 0);
                    assertThat((double) film.red(x, y)).as("%s, %s", x, y).isBetween(expected - 1e-6, expected + 1e-6);
                    lit += expected > 0 ? 1 : 0;
                }
            }
        }
        assertThat(lit).isGreaterThan(200);
    }

    /** The squared distance has no digits left, but the vector to the light must have length 1. */
    @Test
    void lightAtTinyDistance_isNotBrighterThanAtZero() {
        for (double distance = 1e-100; distance > 1e-320; distance *= 0.7) {
            Light light = Light.of("l", LightType.POINT).withPosition(new Vec3(0, distance, 0));
            Scene scene =
                    new Scene(PictureSettings.DEFAULT, new Camera(Vec3.ZERO, new Vec3(0, 0, -1), Vec3.Y, 40), World.DEFAULT, List.of(),
                            List.of(), List.of(light));
            LightingEquation equation = new LightingEquation(LightSource.of(light, scene));
            equation.moveTo(0, 0, 0, 0, 1, 0);
            assertThat(equation.cosine(0, 1, 0)).as("from " + distance).isEqualTo(1);
        }
    }
}
