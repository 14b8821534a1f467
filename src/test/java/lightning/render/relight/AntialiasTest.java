package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.FilmParts;
import lightning.render.shading.LightWeight;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.ViewEffects;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.value.Attenuation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests that edits update finer samples like other rows and retrace them only where an edge of a light moves. */
class AntialiasTest {
    private static final int GRID = 3;

    private static Scene studio(AntialiasMode antialias) {
        return studio(antialias, GRID);
    }

    private static Scene studio(AntialiasMode antialias, int grid) {
        Scene scene = StudioScene.of(LightType.POINT);
        return scene.withPicture(scene.picture().withSize(70, 50).withSampling(new SamplingSettings(antialias, grid)));
    }

    private static Light key(Scene scene) {
        return scene.light(StudioScene.KEY).orElseThrow();
    }

    private static Renderer renderer(Scene scene, Accuracy accuracy) {
        Renderer renderer = new Renderer(RenderOptions.DEFAULT.withReflections(ReflectionMode.STALE).withAccuracy(accuracy));
        renderer.render(scene, Progress.NONE);
        return renderer;
    }

    private static int firstPixels(PixelCache cache) {
        return IntStream.range(0, cache.fineCount()).map(t -> cache.fineTile(t).first().pixels().length).sum();
    }

    private static int restPixels(PixelCache cache) {
        return IntStream.range(0, cache.fineCount()).map(t -> cache.fineTile(t).rest().pixels().length).sum();
    }

    /** Returns a light with other weights that edge detection rounds to the same numbers. */
    private static Light slightlyBrighter(Scene scene) {
        Light brighter = key(scene).withIntensity(key(scene).intensity() * 1.2);
        assertThat(edgeWeight(brighter, scene)).isEqualTo(edgeWeight(key(scene), scene));
        return brighter;
    }

    private static LightWeight edgeWeight(Light light, Scene scene) {
        return FilmParts.of(scene.withLight(light)).edgeWeights()[scene.rig().indexOf(light.name())];
    }

    @Test
    void off_matchesImageWithoutSamples() {
        Scene off = studio(AntialiasMode.OFF);
        Scene other = off.withPicture(off.picture().withSampling(new SamplingSettings(AntialiasMode.OFF, 8)));
        try (Renderer renderer = renderer(off, Accuracy.EXACT)) {
            long bytes = renderer.cache().bytes();
            UpdateResult update = renderer.render(other, Progress.NONE);
            assertThat(update.rays().total()).isZero();
            assertThat(renderer.cache().bytes()).isEqualTo(bytes);
            assertThat(renderer.cache().fineCount()).isZero();
            assertThat(renderer.cache().tile(0).edges()).isNull();
            assertThat(renderer.cache().tile(0).rows().pattern).isNull();
        }
    }

    @Test
    void everyPixel_castsAllSamplesAndNoCenters() {
        Scene scene = studio(AntialiasMode.EVERY);
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            assertThat(renderer.render(scene, Progress.NONE).rays().eye()).isEqualTo(70L * 50 * GRID * GRID);
            assertThat(renderer.cache().tileCount()).isZero();
        }
    }

    @Test
    void edges_castCentersAndEdgeSamples() {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            long eye = renderer.render(studio(AntialiasMode.EDGES), Progress.NONE).rays().eye();
            int fine = firstPixels(renderer.cache());
            assertThat(fine).isBetween(70 * 50 / 20, 70 * 50 / 2);
            assertThat(eye).isEqualTo(70L * 50 + (long) fine * GRID * GRID);
        }
    }

    @Test
    void largeGrid_castsMoreSamplesOnlyWhereFirstFourDiffer() {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            Scene scene = studio(AntialiasMode.EDGES, 4);
            long eye = renderer.render(scene, Progress.NONE).rays().eye();
            int first = firstPixels(renderer.cache());
            int rest = restPixels(renderer.cache());
            assertThat(rest).isBetween(first / 10, first * 9 / 10);
            assertThat(eye).isEqualTo(70L * 50 + 4L * first + 12L * rest);
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(scene).trace(), "antialias-refined");
        }
    }

    @Test
    void edges_useCentersElsewhereAndMeansAtEdges() {
        try (Renderer renderer = renderer(studio(AntialiasMode.EDGES), Accuracy.EXACT)) {
            Film centers = new ReferenceTracer(studio(AntialiasMode.OFF)).trace();
            Film every = new ReferenceTracer(studio(AntialiasMode.EVERY)).trace();
            boolean[] fine = new boolean[70 * 50];
            PixelCache cache = renderer.cache();
            for (int t = 0; t < cache.fineCount(); t++) {
                for (short p : cache.fineTile(t).first().pixels()) {
                    fine[(t / 3 * 32 + p / 32) * 70 + t % 3 * 32 + p % 32] = true;
                }
            }
            for (int i = 0; i < fine.length; i++) {
                float expected = (fine[i] ? every : centers).green(i % 70, i / 70);
                assertThat(renderer.film().green(i % 70, i / 70)).as("pixel %d, %d", i % 70, i / 70).isEqualTo(expected);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(value = AntialiasMode.class, names = {"EDGES", "EVERY"})
    void lightWeight_castsNoRaysBetweenPowersOfTwo(AntialiasMode antialias) {
        Scene scene = studio(antialias, 4);
        Scene brighter = scene.withLight(slightlyBrighter(scene));
        try (Renderer renderer = renderer(scene, Accuracy.EXACT)) {
            assertThat(renderer.render(brighter, Progress.NONE).rays().total()).isZero();
            renderer.updateReflections(Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(brighter).trace(), "antialias-weight");
        }
    }

    @ParameterizedTest
    @EnumSource(Accuracy.class)
    void lightWeight_samplesOtherPixelsAtAnotherPowerOfTwo(Accuracy accuracy) {
        Scene scene = studio(AntialiasMode.EDGES, 4);
        Scene red = scene.withLight(key(scene).withColor(new Rgb(1, 0.2, 0.1)));
        try (Renderer renderer = renderer(scene, accuracy)) {
            UpdateResult update = renderer.render(red, Progress.NONE);
            assertThat(update.rays().eye()).isLessThan(70 * 50);
            double error = FilmError.largestError(renderer.film(), new ReferenceTracer(red, scene).trace());
            assertThat(error).isLessThanOrEqualTo(update.errorBound());
        }
    }

    @Test
    void edgesEnabledLater_castNoShadowRaysForCenters() {
        Scene off = studio(AntialiasMode.OFF);
        Scene edges = studio(AntialiasMode.EDGES);
        // What is stored depends on whether mirrors may show an earlier scene.
        RenderOptions stale = RenderOptions.DEFAULT.withReflections(ReflectionMode.STALE);
        try (Renderer renderer = renderer(off, Accuracy.EXACT); Renderer fresh = new Renderer(stale)) {
            UpdateResult later = renderer.render(edges, Progress.NONE);
            UpdateResult first = fresh.render(edges, Progress.NONE);
            assertThat(later.plan().description()).isEqualTo("samples, reflections");
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(edges).trace(), "antialias-later");
            assertThat(renderer.cache().bytes()).isEqualTo(fresh.cache().bytes());
            try (Renderer plain = new Renderer(RenderOptions.DEFAULT)) {
                long centers = plain.render(off, Progress.NONE).rays().shadow();
                assertThat(later.rays().shadow()).isEqualTo(first.rays().shadow() - centers);
            }
        }
    }

    @Test
    void edgesEnabledLater_ignoreForcedMirrors() {
        Scene off = studio(AntialiasMode.OFF);
        Scene edges = studio(AntialiasMode.EDGES);
        RenderOptions forced = RenderOptions.DEFAULT.withView(ViewEffects.ALL.withForced(Set.of(RenderEffect.REFLECTION)));
        try (Renderer renderer = new Renderer(forced)) {
            renderer.render(off, Progress.NONE);
            renderer.render(edges, Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(edges).trace(), "antialias-forced-mirrors");
        }
    }

    @Test
    void edgesDisabled_freeMemoryAndCastNoRays() {
        Scene off = studio(AntialiasMode.OFF);
        try (Renderer renderer = renderer(studio(AntialiasMode.EDGES), Accuracy.EXACT); Renderer plain = renderer(off, Accuracy.EXACT)) {
            assertThat(renderer.render(off, Progress.NONE).rays().total()).isZero();
            assertThat(renderer.cache().bytes()).isEqualTo(plain.cache().bytes());
            FilmAssert.assertSameBits(renderer.film(), plain.film(), "antialias-given-up");
        }
    }

    @Test
    void movedLight_castsCameraRaysOnlyForNewPixels() {
        Scene scene = studio(AntialiasMode.EDGES, 4);
        Scene moved = scene.withLight(key(scene).withPosition(new Vec3(-1, 4, 3)));
        try (Renderer renderer = renderer(scene, Accuracy.EXACT); Renderer fresh = renderer(moved, Accuracy.EXACT)) {
            long eye = renderer.render(moved, Progress.NONE).rays().eye();
            long all = 4L * firstPixels(fresh.cache()) + 12L * restPixels(fresh.cache());
            assertThat(eye).isPositive().isLessThan(all * 3 / 4);
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(moved, scene).trace(), "antialias-moved");
        }
    }

    @Test
    void movedAndReturnedLight_castsNoCameraRays() {
        Scene scene = studio(AntialiasMode.EDGES, 4);
        Scene moved = scene.withLight(key(scene).withPosition(key(scene).position().plus(new Vec3(0.05, 0, 0))));
        try (Renderer renderer = renderer(scene, Accuracy.EXACT)) {
            long there = renderer.render(moved, Progress.NONE).rays().eye();
            long back = renderer.render(scene, Progress.NONE).rays().eye();
            assertThat(back).isLessThanOrEqualTo(there / 2);
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(scene).trace(), "antialias-returned");
        }
    }

    @Test
    void mirrorThatBecomesDull_showsNothingOfAnEarlierScene() throws Exception {
        Scene file = JenReader.read(Path.of("scenes/balls.jen")).scene();
        Scene scene = file.withPicture(file.picture().withSize(60, 40));
        Material gold = scene.materials().stream().filter(material -> material.name().equals("gold")).findFirst().orElseThrow();
        Scene rough = scene.withMaterial(gold.withShininess(5));
        Scene dull = rough.withMaterial(gold.withShininess(5).withReflective(Rgb.BLACK));
        try (Renderer renderer = renderer(scene, Accuracy.EXACT)) {
            renderer.render(rough, Progress.NONE);
            renderer.render(dull, Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(dull, scene).trace(), "dull-mirror");
        }
    }

    @Test
    void movedLight_matchesReference() {
        Scene scene = studio(AntialiasMode.EDGES);
        Scene moved = scene.withLight(key(scene).withPosition(new Vec3(-1, 4, 3)));
        try (Renderer renderer = renderer(scene, Accuracy.EXACT)) {
            UpdateResult update = renderer.render(moved, Progress.NONE);
            assertThat(update.rays().eye()).isPositive();
            assertThat(update.errorBound()).isZero();
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(moved, scene).trace(), "antialias-moved-exact");
        }
    }

    /** Films of this accuracy contain their weights, so that they are rounded in another order even if no ratio scaled them. */
    @Test
    void movedLightOfAccuracyRatio_addsNoErrorToThatOfAFirstPicture() {
        Scene scene = studio(AntialiasMode.EDGES);
        Scene moved = scene.withLight(key(scene).withPosition(new Vec3(-1, 4, 3)));
        try (Renderer renderer = renderer(scene, Accuracy.RATIO);
                Renderer fresh = new Renderer(RenderOptions.DEFAULT.withReflections(ReflectionMode.STALE).withAccuracy(Accuracy.RATIO))) {
            UpdateResult update = renderer.render(moved, Progress.NONE);
            assertThat(update.rays().eye()).isPositive();
            double first = fresh.render(moved, Progress.NONE).errorBound();
            assertThat(update.errorBound()).isLessThanOrEqualTo(first);
            double error = FilmError.largestError(renderer.film(), new ReferenceTracer(moved, scene).trace());
            assertThat(error).isLessThanOrEqualTo(update.errorBound());
        }
    }

    @ParameterizedTest
    @EnumSource(Accuracy.class)
    void lightWeightAndFalloff_keepErrorBoundAtBothAccuracies(Accuracy accuracy) {
        Scene scene = studio(AntialiasMode.EDGES);
        Light key = key(scene);
        List<Light> edits =
                List.of(key.withIntensity(0.5), key.withColor(new Rgb(1, 0.2, 0.1)), key.withAttenuation(new Attenuation(1, 0.1, 0)));
        try (Renderer renderer = renderer(scene, accuracy)) {
            for (Light edit : edits) {
                UpdateResult update = renderer.render(scene.withLight(edit), Progress.NONE);
                double error = FilmError.largestError(renderer.film(), new ReferenceTracer(scene.withLight(edit), scene).trace());
                assertThat(error).isLessThanOrEqualTo(update.errorBound());
            }
        }
    }

    @ParameterizedTest
    @EnumSource(MirrorStorage.class)
    void updateCanceledAtAnyCheck_leavesPicture(MirrorStorage storage) {
        Scene scene = studio(AntialiasMode.EDGES);
        Scene red = scene.withLight(key(scene).withColor(new Rgb(1, 0.2, 0.1)));
        RenderOptions options = new RenderOptions(Accuracy.EXACT, ReflectionMode.CURRENT, storage, 1);
        try (Renderer renderer = new Renderer(options)) {
            renderer.render(scene, Progress.NONE);
            Film before = renderer.film().copy();
            int checks = 0;
            while (isCanceled(renderer, red, checks)) {
                FilmAssert.assertSameBits(renderer.film(), before, "antialias-canceled-" + checks);
                checks++;
            }
            assertThat(checks).isGreaterThan(50);
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(red).trace(), "antialias-completed");
        }
    }

    private static boolean isCanceled(Renderer renderer, Scene target, int checks) {
        try {
            renderer.render(target, new CancelingProgress(checks));
            return false;
        } catch (CancellationException e) {
            return true;
        }
    }
}
