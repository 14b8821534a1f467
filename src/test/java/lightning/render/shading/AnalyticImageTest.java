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
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

/**
 * Compares every pixel of a sphere of radius 1 over the floor y = 0 with analytic geometry: pinhole rays, the distance of a line
 * from a center, and the tangent cone of the sphere.
 */
class AnalyticImageTest {
    private static final int SIZE = 81;
    private static final Rgb SKY = new Rgb(0.25, 0.5, 1);
    /** Pixels nearer to an outline than this are excluded, in scene units. */
    private static final double OUTLINE = 1e-3;

    private static Material material(String name, Rgb ambient, double diffuse, double specular, double shininess, double reflective) {
        return Material.of(name).withAmbient(ambient).withDiffuse(Rgb.gray(diffuse)).withSpecular(Rgb.gray(specular))
                .withShininess(shininess).withReflective(Rgb.gray(reflective));
    }

    private static Scene scene(Camera camera, int depth, Vec3 ball, List<Material> materials, List<Light> lights) {
        List<SceneNode> nodes = List.of(
                new Shape(Solid.SPHERE, "sphere", "ball", new Placement(ball, Vec3.ZERO, Vec3.ONE)),
                new Shape(Solid.PLANE, "plane", "floor", new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(1000, 1, 1000))));
        return new Scene(new PictureSettings(SIZE, SIZE, depth), camera, new World(1, SKY), materials, nodes, lights);
    }

    /** Returns the unit direction through a pixel's center of a pinhole camera. */
    private static Vec3 ray(Camera camera, int x, int y) {
        Vec3 forward = camera.to().minus(camera.from()).normalized();
        Vec3 right = forward.cross(camera.up()).normalized();
        Vec3 up = right.cross(forward);
        double half = Math.tan(Math.toRadians(camera.fov() / 2));
        double across = ((x + 0.5) / SIZE * 2 - 1) * half;
        double above = (1 - (y + 0.5) / SIZE * 2) * half;
        return forward.plus(right.times(across)).plus(up.times(above)).normalized();
    }

    /** Returns the smallest distance of a line from a point. */
    private static double closestDistance(Vec3 from, Vec3 direction, Vec3 point) {
        return point.minus(from).cross(direction).length();
    }

    /** Returns the hit of a ray that passes the sphere's center at a distance below 1. */
    private static Vec3 hitSphere(Vec3 from, Vec3 direction, Vec3 ball) {
        double near = closestDistance(from, direction, ball);
        return from.plus(direction.times(ball.minus(from).dot(direction) - Math.sqrt(1 - near * near)));
    }

    private static Vec3 hitFloor(Vec3 from, Vec3 direction) {
        return from.plus(direction.times(-from.y() / direction.y()));
    }

    private static void assertGray(Film film, int x, int y, double value, double tolerance) {
        assertThat((double) film.red(x, y)).as("pixel " + x + ", " + y).isCloseTo(value, within(tolerance));
        assertThat(film.green(x, y)).isEqualTo(film.red(x, y));
        assertThat(film.blue(x, y)).isEqualTo(film.red(x, y));
    }

    private static void assertColor(Film film, int x, int y, Rgb color, float factor) {
        assertThat(List.of(film.red(x, y), film.green(x, y), film.blue(x, y))).as("pixel " + x + ", " + y)
                .containsExactly(factor * (float) color.r(), factor * (float) color.g(), factor * (float) color.b());
    }

    /** For a light at height h and a sphere at height c, the shadow is the disc of radius h/√((h − c)² − 1). */
    @Test
    void sphereShadow_isDiscOfTangentCone() {
        double height = 6;
        Vec3 ball = new Vec3(0, 2, 0);
        double radius = height / Math.sqrt((height - ball.y()) * (height - ball.y()) - 1);
        Camera camera = new Camera(new Vec3(1, 5, 9), new Vec3(0, 1, 0), Vec3.Y, 50);
        Light light = Light.of("light", LightType.POINT).withPosition(new Vec3(0, height, 0));
        Film film = new ReferenceTracer(scene(camera, 0, ball,
                List.of(material("ball", Rgb.BLACK, 1, 0, 1, 0), material("floor", Rgb.BLACK, 0.5, 0, 1, 0)), List.of(light))).trace();
        int lit = 0;
        int shadowed = 0;
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x++) {
                Vec3 ray = ray(camera, x, y);
                if (closestDistance(camera.from(), ray, ball) < 1 + OUTLINE || ray.y() > -OUTLINE) {
                    continue;
                }
                Vec3 p = hitFloor(camera.from(), ray);
                double distance = Math.hypot(p.x(), p.z());
                if (distance < radius - OUTLINE) {
                    assertGray(film, x, y, 0, 0);
                    shadowed++;
                } else if (distance > radius + OUTLINE && distance < 400) {
                    assertGray(film, x, y, 0.5 * height / Math.hypot(height, distance), 1e-6);
                    lit++;
                }
            }
        }
        assertThat(lit).isGreaterThan(2000);
        assertThat(shadowed).isGreaterThan(100);
    }

    /** The light is placed on the mirrored center ray of the picture. */
    @Test
    void highlight_peaksAtHalfVector() {
        Vec3 ball = new Vec3(0, 2, 0);
        Vec3 normal = new Vec3(0.3, 0.5, 1).normalized();
        Camera camera = new Camera(new Vec3(1, 3, 6), ball.plus(normal), Vec3.Y, 24);
        Vec3 view = camera.to().minus(camera.from()).normalized();
        Vec3 toLight = view.minus(normal.times(2 * view.dot(normal)));
        double shininess = 20;
        Film film = new ReferenceTracer(scene(camera, 0, ball,
                List.of(material("ball", Rgb.BLACK, 0, 0.8, shininess, 0), material("floor", Rgb.BLACK, 0, 0, 1, 0)),
                List.of(Light.of("light", LightType.DIRECTIONAL).withDirection(toLight.negated())))).trace();
        int checked = 0;
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x++) {
                Vec3 ray = ray(camera, x, y);
                if (closestDistance(camera.from(), ray, ball) > 1 - OUTLINE) {
                    continue;
                }
                Vec3 n = hitSphere(camera.from(), ray, ball).minus(ball);
                double mirrored = ray.minus(n.times(2 * ray.dot(n))).dot(toLight);
                double expected = n.dot(toLight) > 0 ? 0.8 * Math.pow(Math.max(mirrored, 0), shininess) : 0;
                assertGray(film, x, y, expected, 1e-5);
                checked++;
                boolean middle = x == SIZE / 2 && y == SIZE / 2;
                assertThat(film.red(x, y) > 0.8f - 1e-6f).as("brightest at " + x + ", " + y).isEqualTo(middle);
            }
        }
        assertThat(checked).isGreaterThan(2000);
    }

    /** The mirror image is the sphere reflected at the floor, visible where the line to it crosses the floor. */
    @Test
    void mirrorImage_isReflectedSphere() {
        Rgb glow = new Rgb(0.9, 0.4, 0.1);
        Vec3 ball = new Vec3(0, 2, 0);
        Vec3 image = new Vec3(0, -2, 0);
        Vec3 eye = new Vec3(1, 4, 9);
        Camera camera = new Camera(eye, hitFloor(eye, image.minus(eye).normalized()), Vec3.Y, 50);
        List<Material> materials = List.of(material("ball", glow, 0, 0, 1, 0), material("floor", Rgb.BLACK, 0, 0, 1, 0.5));
        Film film = new ReferenceTracer(scene(camera, 1, ball, materials, List.of())).trace();
        Film unfollowed = new ReferenceTracer(scene(camera, 0, ball, materials, List.of())).trace();
        int mirrored = 0;
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x++) {
                Vec3 ray = ray(camera, x, y);
                double direct = closestDistance(eye, ray, ball);
                double reflected = closestDistance(eye, ray, image);
                if (direct < 1 - OUTLINE) {
                    assertColor(film, x, y, glow, 1);
                } else if (direct > 1 + OUTLINE && ray.y() < 0 && hitFloor(eye, ray).length() < 400) {
                    assertColor(unfollowed, x, y, Rgb.BLACK, 1);
                    if (reflected < 1 - OUTLINE) {
                        assertColor(film, x, y, glow, 0.5f);
                        mirrored++;
                    } else if (reflected > 1 + OUTLINE) {
                        assertColor(film, x, y, SKY, 0.5f);
                    }
                }
            }
        }
        assertThat(mirrored).isGreaterThan(100);
        assertColor(film, SIZE / 2, SIZE / 2, glow, 0.5f);
    }
}
