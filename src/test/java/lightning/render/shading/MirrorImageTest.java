package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.FilmAssert;
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
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests mirrors whose images have analytic sums. */
class MirrorImageTest {
    private static final Rgb EMITTED = new Rgb(0.5, 0.25, 1);

    private static Material mirror(Rgb reflective) {
        return Material.of("mirror").withAmbient(EMITTED).withDiffuse(Rgb.BLACK).withShininess(1).withReflective(reflective);
    }

    private static Scene scene(int depth, Material material, Camera camera, SceneNode... nodes) {
        Light light = Light.of("lamp", LightType.POINT).withPosition(new Vec3(0.1, 0.2, 0.3));
        return new Scene(new PictureSettings(33, 25, depth), camera, new World(1, new Rgb(7, 7, 7)), List.of(material), List.of(nodes),
                List.of(light));
    }

    private static SceneNode wall(String name, double z) {
        return new Shape(Solid.PLANE, name, "mirror", new Placement(new Vec3(0, 0, z), new Vec3(90, 0, 0), new Vec3(1e6, 1, 1e6)));
    }

    private static void assertAllPixels(Scene scene, double[] expected) {
        var film = new ReferenceTracer(scene).trace();
        float[] values = film.toScanlines();
        for (int i = 0; i < values.length; i++) {
            assertThat((double) values[i]).as("value " + i).isCloseTo(expected[i % 3], within(1e-6));
        }
        try (WorkerPool workers = new WorkerPool(1)) {
            FilmAssert.assertSameBits(new TraditionalTracer(scene).trace(workers, Progress.NONE).film(), film, "mirrors");
        }
    }

    /** Returns e·(1 − r)·(1 + r + … + r^depth): a geometric series in each channel; black beyond the depth. */
    private static double[] series(Rgb reflective, int depth) {
        double[] r = {reflective.r(), reflective.g(), reflective.b()};
        double[] e = {EMITTED.r(), EMITTED.g(), EMITTED.b()};
        double[] sum = new double[3];
        for (int c = 0; c < 3; c++) {
            sum[c] = e[c] * (1 - Math.pow(r[c], depth + 1));
        }
        return sum;
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 5, 10})
    void parallelMirrors_sumGeometricSeries(int depth) {
        Camera camera = new Camera(new Vec3(0.1, 0.2, 0), new Vec3(0.3, 0.1, -1), Vec3.Y, 60);
        Rgb reflective = new Rgb(0.9, 0.5, 0.99);
        assertAllPixels(scene(depth, mirror(reflective), camera, wall("front", -1), wall("back", 1.5)), series(reflective, depth));
    }

    /** A channel that reflects everything shows only the reflection; one that reflects nothing shows only the surface. */
    @Test
    void reflectivityOfOneChannel_affectsOnlyThatChannel() {
        Camera camera = new Camera(new Vec3(0.1, 0.2, 0), new Vec3(0.3, 0.1, -1), Vec3.Y, 60);
        Rgb reflective = new Rgb(0, 1, 0.5);
        assertAllPixels(scene(10, mirror(reflective), camera, wall("front", -1), wall("back", 1.5)), series(reflective, 10));
        assertThat(series(reflective, 10)).startsWith(0.5, 0);
    }

    /** Every mirrored ray stays inside the sphere, from every camera position; a ray that escaped would return 7. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 0.99, 0.999, 0.99999})
    void mirrorSphereFromInside_losesNoRays(double sideOffset) {
        for (double scale : new double[] {1e-3, 1, 1e6}) {
            Vec3 from = new Vec3(sideOffset, 0, 0).times(scale);
            Camera camera = new Camera(from, from.plus(new Vec3(0, 0.1, -1).times(scale)), Vec3.Y, 170);
            Rgb reflective = new Rgb(0.9, 0.5, 1);
            SceneNode ball = new Shape(Solid.SPHERE, "ball", "mirror", new Placement(Vec3.ZERO, Vec3.ZERO, Vec3.ONE.times(scale)));
            assertAllPixels(scene(10, mirror(reflective), camera, ball), series(reflective, 10));
        }
    }

    /** Camera just above a mirroring floor: it reflects only the sky. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1e-3, 1e-6})
    void mirrorFloorAtGrazingAngle_showsOnlySky(double height) {
        SceneNode floor = new Shape(Solid.PLANE, "floor", "mirror", new Placement(Vec3.ZERO, Vec3.ZERO, new Vec3(1e3, 1, 1e3)));
        Camera camera = new Camera(new Vec3(0, height, 0), new Vec3(0.1, -0.2, -1), Vec3.Y, 10);
        Scene scene = scene(3, mirror(new Rgb(0.5, 0.5, 0.5)), camera, floor);
        assertAllPixels(scene, new double[] {0.25 + 3.5, 0.125 + 3.5, 0.5 + 3.5});
        Scene grazing = scene.withCamera(new Camera(new Vec3(0, height, 0), new Vec3(0.1, height, -1), Vec3.Y, 1e-2));
        for (float red : reds(grazing)) {
            assertThat(red).isIn(7f, 0.25f + 3.5f);
        }
    }

    private static float[] reds(Scene scene) {
        float[] all = new ReferenceTracer(scene).trace().toScanlines();
        float[] reds = new float[all.length / 3];
        for (int i = 0; i < reds.length; i++) {
            reds[i] = all[3 * i];
        }
        return reds;
    }
}
