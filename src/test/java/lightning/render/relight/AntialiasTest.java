package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.tile.Options;
import lightning.render.shading.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.Antialias;
import lightning.scene.Attenuation;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Sampling;
import lightning.scene.Scene;
import lightning.scene.effects.Effect;
import lightning.scene.effects.ViewEffects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Finer samples are rows like all others: edits update them, and only where an edge of a light moves are they traced anew. */
class AntialiasTest {
    private static final int GRID = 3;

    private static Scene studio(Antialias antialias) {
        Scene scene = StudioScene.of(LightType.POINT);
        return scene.withPicture(scene.picture().withSize(70, 50).withSampling(new Sampling(antialias, GRID)));
    }

    private static Light key(Scene scene) {
        return scene.light(StudioScene.KEY).orElseThrow();
    }

    private static Renderer renderer(Scene scene, Accuracy accuracy) {
        Renderer renderer = new Renderer(Options.DEFAULT.withReflections(Reflections.STALE).withAccuracy(accuracy));
        renderer.render(scene, Progress.NONE);
        return renderer;
    }

    private static int finePixels(PixelCache cache) {
        int pixels = 0;
        for (int t = 0; t < cache.fineCount(); t++) {
            pixels += cache.fine(t).shapes().pixels().length + cache.fine(t).lights().pixels().length;
        }
        return pixels;
    }

    @Test
    void off_keepsTheBytesAndRaysOfAPictureWithoutSamples() {
        Scene off = studio(Antialias.OFF);
        Scene other = off.withPicture(off.picture().withSampling(new Sampling(Antialias.OFF, 8)));
        try (Renderer renderer = renderer(off, Accuracy.EXACT)) {
            long bytes = renderer.cache().bytes();
            Update update = renderer.render(other, Progress.NONE);
            assertThat(update.rays().all()).isZero();
            assertThat(renderer.cache().bytes()).isEqualTo(bytes);
            assertThat(renderer.cache().fineCount()).isZero();
            assertThat(renderer.cache().tile(0).codes).isNull();
            assertThat(renderer.cache().tile(0).rows().code).isNull();
        }
    }

    @Test
    void everyPixel_castsAllItsSamplesAndNoCentres() {
        Scene scene = studio(Antialias.EVERY);
        try (Renderer renderer = new Renderer(Options.DEFAULT)) {
            assertThat(renderer.render(scene, Progress.NONE).rays().eye()).isEqualTo(70L * 50 * GRID * GRID);
            assertThat(renderer.cache().tileCount()).isZero();
        }
    }

    @Test
    void edges_castAllCentresAndTheSamplesOfPixelsOnAnEdge() {
        try (Renderer renderer = new Renderer(Options.DEFAULT)) {
            long eye = renderer.render(studio(Antialias.EDGES), Progress.NONE).rays().eye();
            int fine = finePixels(renderer.cache());
            assertThat(fine).isBetween(70 * 50 / 20, 70 * 50 / 2);
            assertThat(eye).isEqualTo(70L * 50 + (long) fine * GRID * GRID);
        }
    }

    @Test
    void pixelsAwayFromEdges_areTheirCentres_andOthersEqualEveryPixelsMean() {
        try (Renderer renderer = renderer(studio(Antialias.EDGES), Accuracy.EXACT)) {
            Film centers = new ReferenceTracer(studio(Antialias.OFF)).trace();
            Film every = new ReferenceTracer(studio(Antialias.EVERY)).trace();
            boolean[] fine = new boolean[70 * 50];
            PixelCache cache = renderer.cache();
            for (int t = 0; t < cache.fineCount(); t++) {
                for (short[] pixels : new short[][] {cache.fine(t).shapes().pixels(), cache.fine(t).lights().pixels()}) {
                    for (short p : pixels) {
                        fine[(t / 3 * 32 + p / 32) * 70 + t % 3 * 32 + p % 32] = true;
                    }
                }
            }
            for (int i = 0; i < fine.length; i++) {
                float expected = (fine[i] ? every : centers).green(i % 70, i / 70);
                assertThat(renderer.film().green(i % 70, i / 70)).as("pixel %d, %d", i % 70, i / 70).isEqualTo(expected);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(value = Antialias.class, names = {"EDGES", "EVERY"})
    void colorOfALight_castsNoRay(Antialias antialias) {
        Scene scene = studio(antialias);
        Scene red = scene.withLight(key(scene).withColor(new Rgb(1, 0.2, 0.1)));
        try (Renderer renderer = renderer(scene, Accuracy.EXACT)) {
            assertThat(renderer.render(red, Progress.NONE).rays().all()).isZero();
            renderer.updateReflections(Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(red).trace(), "antialias-color");
        }
    }

    @Test
    void edgesAskedForLater_castNoShadowRayForTheCentres() {
        Scene off = studio(Antialias.OFF);
        Scene edges = studio(Antialias.EDGES);
        try (Renderer renderer = renderer(off, Accuracy.EXACT); Renderer fresh = new Renderer(Options.DEFAULT)) {
            Update later = renderer.render(edges, Progress.NONE);
            Update first = fresh.render(edges, Progress.NONE);
            assertThat(later.plan().text()).isEqualTo("samples, reflections");
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(edges).trace(), "antialias-later");
            assertThat(renderer.cache().bytes()).isEqualTo(fresh.cache().bytes());
            try (Renderer plain = new Renderer(Options.DEFAULT)) {
                long centers = plain.render(off, Progress.NONE).rays().shadow();
                assertThat(later.rays().shadow()).isEqualTo(first.rays().shadow() - centers);
            }
        }
    }

    @Test
    void edgesAskedForLater_areNotThoseOfMirrorsThatAreForced() {
        Scene off = studio(Antialias.OFF);
        Scene edges = studio(Antialias.EDGES);
        Options forced = Options.DEFAULT.withView(ViewEffects.ALL.forcing(Set.of(Effect.REFLECTION)));
        try (Renderer renderer = new Renderer(forced)) {
            renderer.render(off, Progress.NONE);
            renderer.render(edges, Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(edges).trace(), "antialias-forced-mirrors");
        }
    }

    @Test
    void edgesGivenUp_freeTheirMemoryAndCastNoRay() {
        Scene off = studio(Antialias.OFF);
        try (Renderer renderer = renderer(studio(Antialias.EDGES), Accuracy.EXACT); Renderer plain = renderer(off, Accuracy.EXACT)) {
            assertThat(renderer.render(off, Progress.NONE).rays().all()).isZero();
            assertThat(renderer.cache().bytes()).isEqualTo(plain.cache().bytes());
            FilmAssert.assertSameBits(renderer.film(), plain.film(), "antialias-given-up");
        }
    }

    @Test
    void movedLight_followsItsShadowsEdgeAndNoMore() {
        Scene scene = studio(Antialias.EDGES);
        Scene moved = scene.withLight(key(scene).withPosition(new Vec3(-1, 4, 3)));
        try (Renderer renderer = renderer(scene, Accuracy.EXACT)) {
            long eye = renderer.render(moved, Progress.NONE).rays().eye();
            int samples = 0;
            for (int t = 0; t < renderer.cache().fineCount(); t++) {
                samples += renderer.cache().fine(t).lights().pixels().length * GRID * GRID;
            }
            assertThat(eye).as("only samples at edges of light are traced anew").isPositive().isLessThanOrEqualTo(samples);
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(moved, scene).trace(), "antialias-moved");
        }
    }

    @ParameterizedTest
    @EnumSource(Accuracy.class)
    void movedLight_bringsItsOwnSamplesAtBothLevels(Accuracy accuracy) {
        Scene scene = studio(Antialias.EDGES);
        Scene moved = scene.withLight(key(scene).withPosition(new Vec3(-1, 4, 3)));
        try (Renderer renderer = renderer(scene, accuracy)) {
            Update update = renderer.render(moved, Progress.NONE);
            assertThat(update.rays().eye()).isPositive();
            assertThat(update.errorBound()).isZero();
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(moved, scene).trace(), "antialias-moved-" + accuracy);
        }
    }

    @ParameterizedTest
    @EnumSource(Accuracy.class)
    void weightAndFalloffOfALight_moveNoSampleAtBothLevels(Accuracy accuracy) {
        Scene scene = studio(Antialias.EDGES);
        Light key = key(scene);
        List<Light> edits =
                List.of(key.withIntensity(0.5), key.withColor(new Rgb(1, 0.2, 0.1)), key.withAttenuation(new Attenuation(1, 0.1, 0)));
        try (Renderer renderer = renderer(scene, accuracy)) {
            for (Light edit : edits) {
                Update update = renderer.render(scene.withLight(edit), Progress.NONE);
                assertThat(update.rays().all()).isZero();
                double error = FilmErrors.largestError(renderer.film(), new ReferenceTracer(scene.withLight(edit), scene).trace());
                assertThat(error).isLessThanOrEqualTo(update.errorBound());
            }
        }
    }
}
