package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.trace.Geometry;
import lightning.sample.IndirectScenes;
import lightning.scene.Camera;
import lightning.scene.Scene;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests a camera with another render space origin, as for a moving preview. */
class CameraOriginTest {
    private static final int SIZE = 80;
    /** About half a step of an 8-bit display. */
    private static final float VISIBLE = 2e-3f;

    /** Returns a scene without indirect light, whose gather points lie at other places if positions differ in the last bit. */
    private static Scene scene(String name) throws Exception {
        Scene scene = JenReader.read(Path.of("scenes/" + name + ".jen")).scene();
        return scene.withPicture(scene.picture().withSize(SIZE, SIZE).withIndirect(Optional.empty()));
    }

    /** Returns a camera slightly to the side and above. */
    private static Camera moved(Camera camera) {
        Vec3 toTarget = camera.to().minus(camera.from());
        return new Camera(camera.from().plus(toTarget.cross(camera.up()).times(0.3)).plus(camera.up().times(0.1 * toTarget.length())),
                camera.to(),
                camera.up(), camera.fov());
    }

    @ParameterizedTest
    @ValueSource(strings = {"bird", "balls", "desk", "house"})
    void cameraAwayFromOrigin_rendersSameImage(String name) throws Exception {
        // Cells of indirect light are relative to the origin.
        Scene scene = IndirectScenes.without(scene(name));
        Camera camera = moved(scene.camera());
        Film own = film(scene.withCamera(camera));
        Film elsewhere = film(scene.withCamera(camera.withOrigin(scene.camera().from())));
        int different = 0;
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x++) {
                boolean isUnchanged = Math.abs(own.red(x, y) - elsewhere.red(x, y)) <= VISIBLE
                        && Math.abs(own.green(x, y) - elsewhere.green(x, y)) <= VISIBLE
                        && Math.abs(own.blue(x, y) - elsewhere.blue(x, y)) <= VISIBLE;
                different += isUnchanged ? 0 : 1;
            }
        }
        assertThat(different).as("pixels at edges, where the last bit decides the hit").isLessThan(SIZE * SIZE / 100);
    }

    private static Film film(Scene scene) {
        try (var renderer = new Renderer(RenderOptions.DEFAULT)) {
            renderer.render(scene, Progress.NONE);
            return renderer.film();
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"bird", "house"})
    void cameraWithSameOrigin_movesNoShape(String name) throws Exception {
        Scene scene = scene(name);
        Scene orbit = scene.withCamera(moved(scene.camera()).withOrigin(scene.camera().from()));
        var geometry = Geometry.of(scene);
        assertThat(geometry.canServeEye(scene, orbit.camera().from())).isTrue();
        assertThat(geometry.forScene(orbit, geometry.castsReflections())).isSameAs(geometry);
        try (var renderer = new Renderer(RenderOptions.DEFAULT)) {
            renderer.setSharedGeometry(geometry);
            renderer.render(orbit, Progress.NONE);
            assertThat(renderer.cache().geometry()).isSameAs(geometry);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"bird"})
    void cameraFarFromShapes_cannotReuseGeometry(String name) throws Exception {
        Scene scene = scene(name);
        assertThat(Geometry.of(scene).canServeEye(scene, new Vec3(1e6, 0, 0))).isFalse();
    }
}
