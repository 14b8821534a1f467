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
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.trace.MeshMemory;
import lightning.sample.IndirectScenes;
import lightning.sample.SampleMeshes;
import lightning.sample.Slow;
import lightning.scene.AntialiasMode;
import lightning.scene.Camera;
import lightning.scene.IndirectSettings;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.LayerMaps;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.SurfaceMaps;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Fog;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests memory estimates against the memory that pictures use. */
@Slow
class MemoryEstimateTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);

    private static Scene ballsScene(int width, int height, AntialiasMode antialias, int grid) throws IOException, JenException {
        Scene scene = JenReader.read(Path.of("scenes/balls.jen")).scene();
        return scene.withPicture(
                new PictureSettings(width, height, scene.picture().depth()).withSampling(new SamplingSettings(antialias, grid)));
    }

    /** Returns the bytes of rows, layers, samples and films of a first pass. */
    private static long usedBytes(Scene scene, RenderOptions options) {
        try (Renderer renderer = new Renderer(options)) {
            renderer.render(scene, Progress.NONE);
            PixelCache cache = renderer.cache();
            long film = scene.picture().sampling().isSupersampled() ? 12L * scene.picture().width() * scene.picture().height() : 0;
            return cache.bytes() + cache.colorBytes() + film;
        }
    }

    @ParameterizedTest
    @EnumSource(AntialiasMode.class)
    void upperBound_isNeverExceeded(AntialiasMode antialias) throws Exception {
        for (Accuracy accuracy : Accuracy.values()) {
            for (MirrorStorage storage : MirrorStorage.values()) {
                RenderOptions options = OPTIONS.withAccuracy(accuracy).withStorage(storage);
                Scene scene = ballsScene(96, 64, antialias, 3);
                assertThat(usedBytes(scene, options)).isLessThanOrEqualTo(MemoryEstimate.upperBound(scene, options));
            }
        }
    }

    @Test
    void upperBoundInFog_isNeverExceeded() throws Exception {
        Scene balls = ballsScene(96, 64, AntialiasMode.OFF, 3);
        Scene foggy = balls.withWorld(balls.world().withFog(Fog.NONE.withDensity(0.1)));
        assertThat(usedBytes(foggy, OPTIONS)).isLessThanOrEqualTo(MemoryEstimate.upperBound(foggy, OPTIONS));
        assertThat(MemoryEstimate.upperBound(foggy, OPTIONS) - MemoryEstimate.upperBound(balls, OPTIONS)).as("a float of a light")
                .isGreaterThan(4L * 96 * 64);
    }

    @ParameterizedTest
    @EnumSource(AntialiasMode.class)
    void forecast_isCloseToActual(AntialiasMode antialias) throws Exception {
        Scene scene = ballsScene(640, 448, antialias, 2);
        // Small pictures have partly empty tiles and edges of only a few pixels.
        assertThat(MemoryForecast.of(scene, OPTIONS).bytes(scene.picture())).isCloseTo(usedBytes(scene, OPTIONS), withPercentage(25));
    }

    /** A float of each map for each pixel of whole tiles, which mirrors do not repeat at depth 0. */
    @Test
    void upperBound_countsColumnsOfSurfaceMaps() throws Exception {
        Scene balls = ballsScene(96, 64, AntialiasMode.OFF, 3);
        Scene plain = balls.withPicture(balls.picture().withDepth(0))
                .withMaterials(balls.materials().stream().map(m -> m.withModel(ShadingModel.PRINCIPLED)).toList());
        Optional<TextureMap> map = Optional.of(new TextureMap("m.png", 1, 1, new Texture(1, 1, new float[] {1, 1, 1})));
        Scene mapped = plain.withMaterials(plain.materials().stream()
                .map(m -> m.withSurfaceMaps(SurfaceMaps.NONE.withRoughness(map).withMetalness(map).withF0(map).withSpecularTint(map))
                        .withLayerMaps(LayerMaps.NONE.withCoat(map).withSheen(map).withCoatRoughness(map).withSheenRoughness(map)))
                .toList());
        // Six numbers and two colors. Surfels that reflections show have them, too.
        assertThat(MemoryEstimate.upperBound(mapped, OPTIONS) - MemoryEstimate.upperBound(plain, OPTIONS))
                .isGreaterThanOrEqualTo(48L * 96 * 64);
        assertThat(usedBytes(mapped, OPTIONS)).isLessThanOrEqualTo(MemoryEstimate.upperBound(mapped, OPTIONS));
    }

    @ParameterizedTest
    @EnumSource(AntialiasMode.class)
    void upperBoundWithIndirectLight_isNeverExceeded(AntialiasMode antialias) throws Exception {
        Scene scene = IndirectScenes.with(ballsScene(96, 64, antialias, 3));
        assertThat(usedBytes(scene, OPTIONS)).isLessThanOrEqualTo(MemoryEstimate.upperBound(scene, OPTIONS));
    }

    @ParameterizedTest
    @EnumSource(AntialiasMode.class)
    void forecastWithIndirectLight_isCloseToActual(AntialiasMode antialias) throws Exception {
        Scene scene = IndirectScenes.with(ballsScene(192, 128, antialias, 2));
        MemoryForecast forecast = MemoryForecast.of(scene, OPTIONS);
        assertThat(forecast.bytes(scene.picture())).isCloseTo(usedBytes(scene, OPTIONS), withPercentage(25));
        assertThat(MemoryForecast.upperOf(scene, OPTIONS, PictureParts.ALL, SmallPictures.UNSEEN).bytes(scene.picture()))
                .isGreaterThan(usedBytes(scene, OPTIONS));
    }

    @Test
    void pathsThatDoNotFit_areRejected() throws Exception {
        Scene direct = ballsScene(640, 448, AntialiasMode.OFF, 2);
        Scene dense = direct.withPicture(direct.picture().withIndirect(Optional.of(new IndirectSettings(2, 256, 2, false))));
        long memory = 2 * MemoryEstimate.forecast(direct, OPTIONS);
        assertThatCode(() -> MemoryEstimate.check(direct, OPTIONS.withMemory(memory))).doesNotThrowAnyException();
        assertThatThrownBy(() -> MemoryEstimate.check(dense, OPTIONS.withMemory(memory))).isInstanceOf(PictureTooLargeException.class);
    }

    @Test
    void densePathsThatDoNotFit_areRejectedWithSettingsThatFit() throws Exception {
        Scene direct = ballsScene(640, 448, AntialiasMode.OFF, 2);
        Scene defaults = IndirectScenes.with(direct);
        Scene dense = direct.withPicture(direct.picture().withIndirect(Optional.of(new IndirectSettings(8, 1024, 2, false))));
        long memory = 2 * MemoryForecast.upperOf(defaults, OPTIONS, PictureParts.ALL, SmallPictures.UNSEEN).bytes(defaults.picture());
        assertThatThrownBy(() -> MemoryEstimate.check(dense, OPTIONS.withMemory(memory))).isInstanceOf(PictureTooLargeException.class)
                .hasMessageContaining("it would fit with").hasMessageContaining("indirect light of ");
    }

    @Test
    void forecastWithManyLights_scalesDownPerPixel() throws Exception {
        Scene night = JenReader.read(Path.of("scenes/night.jen")).scene();
        Scene scene = night.withPicture(new PictureSettings(384, 192, night.picture().depth()));
        // A pixel needs a sixth less than in a picture of 192 pixels, and each of these pictures has other edges in its tiles.
        assertThat(MemoryForecast.of(scene, OPTIONS).bytes(scene.picture())).isCloseTo(usedBytes(scene, OPTIONS), withPercentage(10));
    }

    @Test
    void forecastOfManySamples_usesFewSamples() throws Exception {
        Scene scene = ballsScene(320, 224, AntialiasMode.EDGES, 4);
        // In addition, sample tiles are filled better if there are more samples.
        assertThat(MemoryForecast.of(scene, OPTIONS).bytes(scene.picture())).isCloseTo(usedBytes(scene, OPTIONS), withPercentage(35));
    }

    @Test
    void oversizedImage_isRejectedWithFittingSize() throws Exception {
        RenderOptions options = OPTIONS.withMemory(1_000_000_000);
        Scene huge = ballsScene(16384, 16384, AntialiasMode.EVERY, 8);
        assertThatThrownBy(() -> MemoryEstimate.check(huge, options)).isInstanceOf(PictureTooLargeException.class)
                .hasMessageMatching(
                        "the picture needs about \\d{3,4}\\.\\d GB of memory, and 1\\.0 GB is available; it would fit with a size of .+")
                .satisfies(e -> {
                    Matcher size = Pattern.compile("(\\d+)x(\\d+)").matcher(e.getMessage());
                    assertThat(size.find()).isTrue();
                    PictureSettings smaller = huge.picture().withSize(Integer.parseInt(size.group(1)), Integer.parseInt(size.group(2)));
                    MemoryEstimate.check(huge.withPicture(smaller), options);
                });
    }

    @Test
    void fewerSamples_areSuggestedIfTheyFit() throws Exception {
        Scene fine = ballsScene(1920, 1080, AntialiasMode.EVERY, 8);
        RenderOptions options = OPTIONS.withMemory(4_000_000_000L);
        assertThatThrownBy(() -> MemoryEstimate.check(fine, options)).message().satisfies(message -> {
            Matcher samples = Pattern.compile("or with (\\d)x\\1 samples").matcher(message);
            assertThat(samples.find()).isTrue();
            MemoryEstimate.check(ballsScene(1920, 1080, AntialiasMode.EVERY, Integer.parseInt(samples.group(1))), options);
        });
    }

    @Test
    void meshes_reduceMemoryForImage() throws Exception {
        Scene balls = ballsScene(64, 64, AntialiasMode.OFF, 2);
        Solid.TriangleMesh mesh = SampleMeshes.solid(SampleMeshes.ball(30, 40, true));
        List<SceneNode> nodes = new ArrayList<>(balls.nodes());
        nodes.add(new Shape(mesh, "mesh", "default", Placement.IDENTITY));
        nodes.add(new Shape(mesh, "again", "default", Placement.IDENTITY));
        Scene scene = balls.withNodes(nodes);
        long each = 165L * mesh.mesh().triangleCount();
        long picture = MemoryEstimate.upperBound(scene, OPTIONS);
        assertThatCode(() -> MemoryEstimate.check(scene, OPTIONS.withMemory(picture + each + each))).doesNotThrowAnyException();
        assertThatThrownBy(() -> MemoryEstimate.check(scene, OPTIONS.withMemory(each / 2))).isInstanceOf(PictureTooLargeException.class);
        assertThat(MeshMemory.bytes(scene)).isBetween(144L * mesh.mesh().triangleCount(), each + each / 10);
    }

    @Test
    void mirrorsAsShapes_areOmittedFromMessage() throws Exception {
        Scene scene = ballsScene(640, 448, AntialiasMode.OFF, 2);
        long full = MemoryForecast.of(scene, OPTIONS).bytes(scene.picture());
        assertThatThrownBy(() -> MemoryEstimate.check(scene, OPTIONS.withMemory(full - 1)))
                .isInstanceOfSatisfying(PictureTooLargeException.class, e -> {
                    assertThat(e.message(suggestion -> Optional.of(suggestion.description()))).contains("mirrors stored as shapes");
                    assertThat(e).message().doesNotContain("shapes");
                });
    }

    @Test
    void oversizedFilm_isRejectedWithFittingSize() throws Exception {
        PictureSettings huge = ballsScene(16384, 16384, AntialiasMode.EVERY, 8).picture();
        // 12 bytes per pixel are 3.2 GB.
        assertThatThrownBy(() -> MemoryEstimate.checkFilm(huge, 1_000_000_000)).isInstanceOf(PictureTooLargeException.class)
                .hasMessageStartingWith(
                        "the picture needs about 3.2 GB of memory, and 1.0 GB is available; it would fit with a size of 9120x9120");
        assertThatCode(() -> MemoryEstimate.checkFilm(huge.withSize(9120, 9120), 1_000_000_000)).doesNotThrowAnyException();
        assertThatCode(() -> MemoryEstimate.checkFilm(huge, 12L << 28)).doesNotThrowAnyException();
    }

    @Test
    void fittingImageAboveUpperBound_isAccepted() throws Exception {
        Scene scene = ballsScene(640, 448, AntialiasMode.EDGES, 2);
        // Maximum overestimate of a forecast, as tested above.
        RenderOptions options = OPTIONS.withMemory((long) (1.25 * usedBytes(scene, OPTIONS)));
        assertThat(MemoryEstimate.upperBound(scene, OPTIONS)).isGreaterThan(options.memory());
        assertThatCode(() -> MemoryEstimate.check(scene, options)).doesNotThrowAnyException();
    }

    @Test
    void rejectedImage_leavesRendererUnchanged() throws Exception {
        Scene small = ballsScene(64, 48, AntialiasMode.OFF, 2);
        try (Renderer renderer = new Renderer(OPTIONS.withMemory(1_000_000_000))) {
            renderer.render(small, Progress.NONE);
            Scene huge = ballsScene(16384, 16384, AntialiasMode.EVERY, 8);
            assertThatThrownBy(() -> renderer.render(huge, Progress.NONE)).isInstanceOf(PictureTooLargeException.class);
            assertThat(renderer.scene()).isEqualTo(small);
        }
    }

    @Test
    void previousImage_countsTowardsMemory() throws Exception {
        Scene first = ballsScene(128, 128, AntialiasMode.OFF, 2);
        Scene second =
                first.withCamera(new Camera(first.camera().from(), first.camera().to(), first.camera().up(), first.camera().fov() * 0.9));
        long each = usedBytes(first, OPTIONS);
        try (Renderer renderer = new Renderer(OPTIONS.withMemory(each * 3 / 2))) {
            renderer.render(first, Progress.NONE);
            assertThatThrownBy(() -> renderer.render(second, Progress.NONE)).isInstanceOf(PictureTooLargeException.class);
            renderer.clear();
            assertThatCode(() -> renderer.render(second, Progress.NONE)).doesNotThrowAnyException();
        }
    }

    @Test
    void imageThatFitsAlone_replacesPreviousImage() throws Exception {
        Scene first = ballsScene(128, 128, AntialiasMode.OFF, 2);
        Scene second = first.withCamera(new Camera(first.camera().from(), first.camera().to(), first.camera().up(), 30));
        try (Renderer renderer = new Renderer(OPTIONS.withMemory(usedBytes(first, OPTIONS) * 3 / 2))) {
            renderer.render(first, Progress.NONE);
            assertThat(renderer.renderOrClear(second, Progress.NONE).rays().eye()).isEqualTo(128L * 128);
            assertThat(renderer.scene()).isEqualTo(second);
            Scene huge = ballsScene(16384, 16384, AntialiasMode.EVERY, 8);
            for (boolean hasPicture : new boolean[] {true, false}) {
                assertThat(renderer.state().hasPicture()).isEqualTo(hasPicture);
                assertThatThrownBy(() -> renderer.renderOrClear(huge, Progress.NONE)).isInstanceOf(PictureTooLargeException.class);
                assertThat(renderer.state().hasPicture()).isFalse();
            }
        }
    }
}
