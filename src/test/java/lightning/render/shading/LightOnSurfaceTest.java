package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.math.Ray;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
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
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests that a light on a lampshade lights a floor in front of it without speckles, and nothing on the other side. */
class LightOnSurfaceTest {
    private static final Material WHITE = Material.of("white").withDiffuse(Rgb.WHITE).withShininess(1);
    private static final Placement GROUP = new Placement(new Vec3(0.3, 2.7, -0.4), new Vec3(37, 74, -21), new Vec3(1.3, 1.3, 1.3));
    private static final Placement IN_GROUP = new Placement(new Vec3(0.1, 0, 0.2), new Vec3(11, -35, 60), new Vec3(0.7, 0.7, 0.7));

    /** Provides a shape, a point of its surface and the outward normal there in object space; a square has none. */
    static Stream<Arguments> shades() {
        return Stream.of(
                Arguments.of(new Shape(Solid.PLANE, "shade", "white", IN_GROUP), new Vec3(0.1, 0, -0.2), Optional.empty()),
                Arguments.of(new Shape(Solid.PLANE, "shade", "white", IN_GROUP), new Vec3(0.5, 0, 0.5), Optional.empty()),
                Arguments.of(new Shape(Solid.SPHERE, "shade", "white", IN_GROUP), new Vec3(0.48, -0.6, 0.64),
                        Optional.of(new Vec3(0.48, -0.6, 0.64))),
                Arguments.of(new Shape(Solid.CONE, "shade", "white", IN_GROUP), Vec3.ZERO, Optional.of(Vec3.Y.negated())),
                Arguments.of(new Shape(Solid.CONE, "shade", "white", IN_GROUP), new Vec3(0.3, 0.5, 0.4),
                        Optional.of(new Vec3(0.6, 1, 0.8))),
                Arguments.of(new Shape(Solid.CYLINDER, "shade", "white", IN_GROUP), Vec3.Y, Optional.of(Vec3.Y)),
                Arguments.of(new Shape(Solid.CYLINDER, "shade", "white", IN_GROUP), new Vec3(0.6, 0.3, -0.8),
                        Optional.of(new Vec3(0.6, 0, -0.8))));
    }

    @ParameterizedTest
    @MethodSource("shades")
    void lightOnSurface_lightsFrontAndLeavesBackDark(Shape shade, Vec3 position, Optional<Vec3> normal) {
        SceneNode group = new NodeGroup("lamp", GROUP, List.of(shade));
        Vec3 at = GROUP.transform().transformPoint(IN_GROUP.transform().transformPoint(position));
        Optional<Vec3> front = normal.map(n -> GROUP.transform().transformVector(IN_GROUP.transform().transformVector(n)));
        SceneNode floor = new Shape(Solid.PLANE, "floor", "white", new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(40, 1, 40)));
        Scene scene =
                new Scene(new PictureSettings(64, 48, 0), new Camera(new Vec3(1, 7, 12), new Vec3(0, 0.5, 0), Vec3.Y, 50), World.DEFAULT,
                        List.of(WHITE), List.of(floor, group), List.of(Light.of("l", LightType.POINT).withPosition(at)));
        Film film = new ReferenceTracer(scene).trace();
        Geometry geometry = Geometry.of(scene);
        int compared = 0;
        for (int y = 0; y < film.height(); y++) {
            for (int x = 0; x < film.width(); x++) {
                Ray ray = new PixelRays(scene).ray(x, y);
                if (BruteForce.nearest(geometry, ray) == 0) {
                    Vec3 point = geometry.toScene(ray.direction().times(geometry.distance(0, ray)));
                    Vec3 to = at.minus(point);
                    double above = front.map(n -> -to.dot(n) / to.length()).orElse(1.0);
                    if (Math.abs(above) > 1e-4) {
                        double expected = above > 0 ? to.y() / to.length() : 0;
                        assertThat((double) film.red(x, y)).as("%s, %s", x, y).isBetween(expected - 1e-5, expected + 1e-5);
                        compared++;
                    }
                }
            }
        }
        assertThat(compared).isGreaterThan(1000);
        try (WorkerPool workers = new WorkerPool(2)) {
            FilmAssert.assertSameBits(new TraditionalTracer(scene).trace(workers, Progress.NONE).film(), film, "lamp-on-surface");
        }
    }

    /** The surface at the camera hides nothing in front of it. */
    @ParameterizedTest
    @MethodSource("shades")
    void cameraAtLight_seesSurfaceInFront(Shape shade, Vec3 position, Optional<Vec3> normal) {
        SceneNode group = new NodeGroup("lamp", GROUP, List.of(shade));
        Vec3 at = GROUP.transform().transformPoint(IN_GROUP.transform().transformPoint(position));
        Vec3 down = new Vec3(0.2, -1, 0.1);
        Vec3 look = normal.map(n -> GROUP.transform().transformVector(IN_GROUP.transform().transformVector(n))).orElse(down);
        SceneNode floor = new Shape(Solid.PLANE, "floor", "white", new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(4000, 1, 4000)));
        Scene scene = new Scene(new PictureSettings(48, 48, 0), new Camera(at, at.plus(look), new Vec3(0.3, 0.5, 0.9), 60), World.DEFAULT,
                List.of(WHITE), List.of(floor, group), List.of());
        Geometry geometry = Geometry.of(scene);
        for (int y = 0; y < 48; y++) {
            for (int x = 0; x < 48; x++) {
                Ray ray = new PixelRays(scene).ray(x, y);
                assertThat(BruteForce.nearest(geometry, ray)).as("%s, %s", x, y).isNotEqualTo(1);
            }
        }
    }
}
