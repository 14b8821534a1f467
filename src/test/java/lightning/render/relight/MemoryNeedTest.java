package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.data.Percentage.withPercentage;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.base.work.Progress;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.cache.PixelCache;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.tile.MirrorStorage;
import lightning.render.relight.tile.Options;
import lightning.render.trace.MeshMemory;
import lightning.sample.Meshes;
import lightning.sample.Slow;
import lightning.scene.Antialias;
import lightning.scene.Camera;
import lightning.scene.Node;
import lightning.scene.Picture;
import lightning.scene.Placement;
import lightning.scene.Sampling;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.Solid;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Memory reckoned beforehand, against what pictures then take. */
@Slow
class MemoryNeedTest {
    private static final Options OPTIONS = Options.DEFAULT.withThreads(1);

    private static Scene balls(int width, int height, Antialias antialias, int grid) throws IOException, JenException {
        Scene scene = JenReader.read(Path.of("scenes/balls.jen")).scene();
        return scene.withPicture(new Picture(width, height, scene.picture().depth()).withSampling(new Sampling(antialias, grid)));
    }

    /** Rows, layers, samples and films of a first pass. */
    private static long taken(Scene scene, Options options) {
        try (Renderer renderer = new Renderer(options)) {
            renderer.render(scene, Progress.NONE);
            PixelCache cache = renderer.cache();
            long film = scene.picture().sampling().isFine() ? 12L * scene.picture().width() * scene.picture().height() : 0;
            return cache.bytes() + cache.all().size() * 12L * 1024 + film;
        }
    }

    @ParameterizedTest
    @EnumSource(Antialias.class)
    void most_isNeverExceeded(Antialias antialias) throws Exception {
        for (Accuracy accuracy : Accuracy.values()) {
            for (MirrorStorage storage : MirrorStorage.values()) {
                Options options = OPTIONS.withAccuracy(accuracy).withStorage(storage);
                Scene scene = balls(96, 64, antialias, 3);
                assertThat(taken(scene, options)).isLessThanOrEqualTo(MemoryNeed.most(scene, options));
            }
        }
    }

    @ParameterizedTest
    @EnumSource(Antialias.class)
    void forecast_isNearToWhatIsTaken(Antialias antialias) throws Exception {
        Scene scene = balls(640, 448, antialias, 2);
        // Small pictures have part of their tiles empty, and know edges of a few pixels only.
        assertThat(Forecast.of(scene, OPTIONS).bytes(scene.picture())).isCloseTo(taken(scene, OPTIONS), withPercentage(25));
    }

    @Test
    void forecastOfManyLights_knowsThatLargePicturesTakeLessOfAPixel() throws Exception {
        Scene night = JenReader.read(Path.of("scenes/night.jen")).scene();
        Scene scene = night.withPicture(new Picture(800, 448, night.picture().depth()));
        // A pixel takes a sixth less than in a picture of 192 pixels, and each of these pictures has other edges in its tiles.
        assertThat(Forecast.of(scene, OPTIONS).bytes(scene.picture())).isCloseTo(taken(scene, OPTIONS), withPercentage(10));
    }

    @Test
    void forecastOfMoreSamples_isMadeOfFew() throws Exception {
        Scene scene = balls(320, 224, Antialias.EDGES, 4);
        // Beside the above, tiles of samples are filled better where there are more of them.
        assertThat(Forecast.of(scene, OPTIONS).bytes(scene.picture())).isCloseTo(taken(scene, OPTIONS), withPercentage(35));
    }

    @Test
    void pictureThatDoesNotFit_isRefusedWithASizeThatDoes() throws Exception {
        Options options = OPTIONS.withMemory(1_000_000_000);
        Scene huge = balls(16384, 16384, Antialias.EVERY, 8);
        assertThatThrownBy(() -> MemoryNeed.check(huge, options)).isInstanceOf(PictureTooLarge.class)
                .hasMessageMatching(
                        "the picture needs about \\d{3,4}\\.\\d GB of memory and may have 1\\.0 GB; it would fit with a size of .+")
                .satisfies(e -> {
                    Matcher size = Pattern.compile("(\\d+)x(\\d+)").matcher(e.getMessage());
                    assertThat(size.find()).isTrue();
                    Picture smaller = huge.picture().withSize(Integer.parseInt(size.group(1)), Integer.parseInt(size.group(2)));
                    MemoryNeed.check(huge.withPicture(smaller), options);
                });
    }

    @Test
    void fewerSamples_areNamedWhereTheyFit() throws Exception {
        Scene fine = balls(1920, 1080, Antialias.EVERY, 8);
        Options options = OPTIONS.withMemory(4_000_000_000L);
        assertThatThrownBy(() -> MemoryNeed.check(fine, options)).message().satisfies(message -> {
            Matcher samples = Pattern.compile("or with (\\d)x\\1 samples").matcher(message);
            assertThat(samples.find()).isTrue();
            MemoryNeed.check(balls(1920, 1080, Antialias.EVERY, Integer.parseInt(samples.group(1))), options);
        });
    }

    @Test
    void meshes_leaveLessMemoryForThePicture() throws Exception {
        Scene balls = balls(64, 64, Antialias.OFF, 2);
        Solid.Triangles mesh = Meshes.solid(Meshes.ball(30, 40, true));
        List<Node> nodes = new ArrayList<>(balls.nodes());
        nodes.add(new Shape(mesh, "mesh", "default", Placement.IDENTITY));
        nodes.add(new Shape(mesh, "again", "default", Placement.IDENTITY));
        Scene scene = balls.withNodes(nodes);
        long each = 130L * mesh.mesh().triangleCount();
        long picture = MemoryNeed.most(scene, OPTIONS);
        assertThatCode(() -> MemoryNeed.check(scene, OPTIONS.withMemory(picture + each + each))).doesNotThrowAnyException();
        assertThatThrownBy(() -> MemoryNeed.check(scene, OPTIONS.withMemory(each / 2))).isInstanceOf(PictureTooLarge.class);
        assertThat(MeshMemory.bytes(scene)).isBetween(112L * mesh.mesh().triangleCount(), each + each / 10);
    }

    @Test
    void mirrorsAsShapes_areAWayThatTheMessageLeavesOut() throws Exception {
        Scene scene = balls(640, 448, Antialias.OFF, 2);
        long full = Forecast.of(scene, OPTIONS).bytes(scene.picture());
        assertThatThrownBy(() -> MemoryNeed.check(scene, OPTIONS.withMemory(full - 1))).isInstanceOfSatisfying(PictureTooLarge.class, e -> {
            assertThat(e.message(way -> Optional.of(way.text()))).contains("mirrors kept as shapes");
            assertThat(e).message().doesNotContain("shapes");
        });
    }

    @Test
    void filmThatDoesNotFit_isRefusedWithASizeThatDoes() throws Exception {
        Picture huge = balls(16384, 16384, Antialias.EVERY, 8).picture();
        // 12 bytes a pixel are 3.2 GB.
        assertThatThrownBy(() -> MemoryNeed.checkFilm(huge, 1_000_000_000)).isInstanceOf(PictureTooLarge.class)
                .hasMessageStartingWith(
                        "the picture needs about 3.2 GB of memory and may have 1.0 GB; it would fit with a size of 9120x9120");
        assertThatCode(() -> MemoryNeed.checkFilm(huge.withSize(9120, 9120), 1_000_000_000)).doesNotThrowAnyException();
        assertThatCode(() -> MemoryNeed.checkFilm(huge, 12L << 28)).doesNotThrowAnyException();
    }

    @Test
    void pictureThatFitsAlthoughTheFormulaFears_isNotRefused() throws Exception {
        Scene scene = balls(640, 448, Antialias.EDGES, 2);
        // What a forecast may be too high by, as held above.
        Options options = OPTIONS.withMemory((long) (1.25 * taken(scene, OPTIONS)));
        assertThat(MemoryNeed.most(scene, OPTIONS)).isGreaterThan(options.memory());
        assertThatCode(() -> MemoryNeed.check(scene, options)).doesNotThrowAnyException();
    }

    @Test
    void rendererRefusesBeforeItWorks_andKeepsItsPicture() throws Exception {
        Scene small = balls(64, 48, Antialias.OFF, 2);
        try (Renderer renderer = new Renderer(OPTIONS.withMemory(1_000_000_000))) {
            renderer.render(small, Progress.NONE);
            Scene huge = balls(16384, 16384, Antialias.EVERY, 8);
            assertThatThrownBy(() -> renderer.render(huge, Progress.NONE)).isInstanceOf(PictureTooLarge.class);
            assertThat(renderer.scene()).isEqualTo(small);
        }
    }

    @Test
    void pictureBefore_isCountedBesideTheNewOne() throws Exception {
        Scene first = balls(128, 128, Antialias.OFF, 2);
        Scene second =
                first.withCamera(new Camera(first.camera().from(), first.camera().to(), first.camera().up(), first.camera().fov() * 0.9));
        long each = taken(first, OPTIONS);
        try (Renderer renderer = new Renderer(OPTIONS.withMemory(each * 3 / 2))) {
            renderer.render(first, Progress.NONE);
            assertThatThrownBy(() -> renderer.render(second, Progress.NONE)).isInstanceOf(PictureTooLarge.class);
            renderer.forget();
            assertThatCode(() -> renderer.render(second, Progress.NONE)).doesNotThrowAnyException();
        }
    }
}
