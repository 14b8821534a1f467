package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;

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
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Renders the same frame from near and from ever larger distances and compares every pixel with analytic geometry. Errors may only
 * lie within float precision at that distance from a shadow edge.
 */
class TelephotoTest {
    private static final int WIDTH = 150;
    private static final int HEIGHT = 100;
    private static final Vec3 BALL = new Vec3(0, 1, 0);
    private static final Vec3 LIGHT = new Vec3(3, 6, 2);
    private static final Material WHITE = Material.of("white").withDiffuse(Rgb.WHITE).withShininess(1);

    @ParameterizedTest
    @ValueSource(doubles = {10, 100, 1000, 10_000, 30_000})
    void distantCamera_isExactExceptShadowEdges(double far) {
        double half = 4 / far;
        Camera camera = new Camera(new Vec3(0.3, 0.6, 1).normalized().times(far), Vec3.ZERO, Vec3.Y, 2 * Math.toDegrees(Math.atan(half)));
        List<SceneNode> nodes = List.of(new Shape(Solid.SPHERE, "ball", "white", new Placement(BALL, Vec3.ZERO, Vec3.ONE)),
                new Shape(Solid.PLANE, "floor", "white", new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(100, 1, 100))));
        Film film = new ReferenceTracer(new Scene(new PictureSettings(WIDTH, HEIGHT, 0), camera, World.DEFAULT, List.of(WHITE), nodes,
                List.of(Light.of("l", LightType.POINT).withPosition(LIGHT)))).trace();
        int near = 0;
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                Vec3 ray = ray(camera, half, x, y);
                Vec3 point = hit(camera.from(), ray);
                // The stored point is rounded to float and offset from the surface by up to two such roundings.
                double error = 3 * 0x1p-24 * point.minus(camera.from()).length();
                Vec3 to = LIGHT.minus(point);
                boolean floor = point.y() < 1e-9;
                double sideOffset = to.normalized().cross(BALL.minus(point)).length() - 1;
                if (Math.abs(closestDistance(camera.from(), ray) - 1) < 1e-9 || floor && Math.abs(sideOffset) <= error) {
                    near++;
                    continue;
                }
                Vec3 normal = floor ? Vec3.Y : point.minus(BALL);
                double expected = floor && sideOffset < 0 ? 0 : Math.max(normal.dot(to) / to.length(), 0);
                double margin = error / to.length() + 1e-6;
                assertThat((double) film.red(x, y)).as("%s, %s from %s", x, y, far).isBetween(expected - margin, expected + margin);
            }
        }
        assertThat(near).isLessThanOrEqualTo((int) (4 + far / 1000 * 5));
    }

    private static Vec3 ray(Camera camera, double half, int x, int y) {
        Vec3 forward = camera.from().normalized().negated();
        Vec3 right = forward.cross(camera.up()).normalized();
        Vec3 up = right.cross(forward);
        return forward.plus(right.times((x + 0.5 - WIDTH / 2.0) * 2 * half / HEIGHT))
                .plus(up.times((HEIGHT / 2.0 - y - 0.5) * 2 * half / HEIGHT))
                .normalized();
    }

    private static double closestDistance(Vec3 from, Vec3 ray) {
        return BALL.minus(from).cross(ray).length();
    }

    private static Vec3 hit(Vec3 from, Vec3 ray) {
        Vec3 to = BALL.minus(from);
        double along = to.dot(ray);
        double passes = closestDistance(from, ray);
        return from.plus(ray.times(passes < 1 ? along - Math.sqrt(1 - passes * passes) : -from.y() / ray.y()));
    }
}
