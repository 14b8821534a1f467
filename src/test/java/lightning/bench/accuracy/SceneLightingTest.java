package lightning.bench.accuracy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.trace.Geometry;
import lightning.sample.Nightly;
import lightning.sample.Slow;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests the lighting of all scenes: every light is visible, and no image is overexposed or underexposed. */
@Slow
class SceneLightingTest {
    private static final int SIZE = 64;
    /** Minimum visible area of a light: 1/500 of the image. */
    private static final long MIN_PIXELS = SIZE * SIZE / 500;

    /** Changes only with the scenes, whose pictures are checked below in the usual check. */
    @ParameterizedTest
    @Nightly
    @MethodSource("names")
    void everyLight_changesThePictureInPlaces(String name) {
        Scene small = SceneFiles.read(name, SIZE);
        var geometry = Geometry.of(small);
        List<String> idle = new ArrayList<>();
        try (var workers = new WorkerPool(2)) {
            Film all = trace(small, geometry, workers);
            for (Light light : small.lights()) {
                Film without = trace(small.withLight(light.withOn(false)), geometry, workers);
                if (visiblyDarker(without, all) < MIN_PIXELS) {
                    idle.add(light.name());
                }
            }
        }
        assertThat(idle).as("lights without visible effect").isEmpty();
    }

    @ParameterizedTest
    @MethodSource("names")
    void picture_isNeitherClippedNorBlack(String name) {
        Scene scene = SceneFiles.readAll(name);
        Scene small = scene.withPicture(scene.picture().withSize(SIZE / 2, SIZE / 2));
        try (var workers = new WorkerPool(2)) {
            Film film = trace(small, Geometry.of(small), workers);
            assertThat(share(film, 1, Float.MAX_VALUE)).as("share of white pixels").isLessThan(0.01);
            assertThat(share(film, 0, 0.003f)).as("share of black pixels").isLessThan(0.1);
        }
    }

    static List<String> names() {
        return SceneFiles.names();
    }

    private static Film trace(Scene scene, Geometry geometry, WorkerPool workers) {
        return new TraditionalTracer(scene, geometry).trace(workers, Progress.NONE).film();
    }

    /** Counts pixels that lose at least 8 of 255 display steps in some channel. */
    private static long visiblyDarker(Film withoutLight, Film allLights) {
        ViewTransform view = ViewTransform.DEFAULT;
        long count = 0;
        for (int y = 0; y < allLights.height(); y++) {
            for (int x = 0; x < allLights.width(); x++) {
                int lost = Math.max(view.encode(allLights.red(x, y)) - view.encode(withoutLight.red(x, y)),
                        Math.max(view.encode(allLights.green(x, y)) - view.encode(withoutLight.green(x, y)),
                                view.encode(allLights.blue(x, y)) - view.encode(withoutLight.blue(x, y))));
                count += lost >= 8 ? 1 : 0;
            }
        }
        return count;
    }

    /** Returns the share of pixels whose channels are all from {@code min} to {@code max}. */
    private static double share(Film film, float min, float max) {
        long count = 0;
        for (int y = 0; y < film.height(); y++) {
            for (int x = 0; x < film.width(); x++) {
                float low = Math.min(film.red(x, y), Math.min(film.green(x, y), film.blue(x, y)));
                float high = Math.max(film.red(x, y), Math.max(film.green(x, y), film.blue(x, y)));
                count += low >= min && high <= max ? 1 : 0;
            }
        }
        return count / (double) (film.width() * film.height());
    }
}
