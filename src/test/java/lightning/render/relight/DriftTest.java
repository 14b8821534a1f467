package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.work.Progress;
import lightning.bench.accuracy.RandomEdits;
import lightning.render.RenderOptions;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.ErrorBound;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.Nightly;
import lightning.sample.Slow;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the error of a picture after many consecutive edits. */
@Slow
class DriftTest {
    private static final int EDITS = Integer.getInteger("lightning.edits", 10_000);

    private static Renderer renderer(Accuracy accuracy) {
        return new Renderer(new RenderOptions(accuracy, ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, 1));
    }

    /** {@link ExactnessTest} makes short sessions in the usual check. */
    @Test
    @Nightly
    void tenThousandEdits_matchAtExactAccuracy() {
        RandomEdits edits = new RandomEdits(1);
        Scene scene = StudioScene.withFourLights(12, 10);
        try (Renderer renderer = renderer(Accuracy.EXACT)) {
            for (int n = 0; n < EDITS; n++) {
                scene = edits.next(scene);
                renderer.render(scene, Progress.NONE);
                if (n % 100 == 99) {
                    FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(scene).trace(), "drift after " + n);
                }
            }
        }
    }

    /** {@link RatioTest} makes short sessions in the usual check. */
    @Test
    @Nightly
    void tenThousandEdits_stayInvisibleAtRatioAccuracy() {
        RandomEdits edits = new RandomEdits(2);
        Scene scene = StudioScene.withFourLights(12, 10);
        try (Renderer ratio = renderer(Accuracy.RATIO); Renderer exact = renderer(Accuracy.EXACT)) {
            for (int n = 0; n < EDITS; n++) {
                scene = edits.next(scene);
                UpdateResult update = ratio.render(scene, Progress.NONE);
                exact.render(scene, Progress.NONE);
                assertThat(FilmError.largestError(ratio.film(), exact.film())).as("edit " + n).isLessThanOrEqualTo(update.errorBound());
                assertThat(FilmError.largestStep(ratio.film(), exact.film())).as("displayed, edit " + n).isLessThan(0.5);
            }
        }
    }

    /** A relative error of 0.0045 would be half an 8-bit step: that is 37 000 edits of one light. */
    @Test
    void continuousDrag_refreshesBeforeErrorIsVisible() {
        Scene scene = StudioScene.withFourLights(4, 4);
        boolean refreshed = false;
        try (Renderer renderer = renderer(Accuracy.RATIO)) {
            renderer.render(scene, Progress.NONE);
            for (int n = 0; n < 100_000 && !refreshed; n++) {
                scene = scene.withLight(scene.lights().getFirst().withIntensity(1 + 0.3 * Math.sin(n)));
                UpdateResult update = renderer.render(scene, Progress.NONE);
                refreshed = update.wasRefreshed();
                assertThat(update.errorBound() / brightest(renderer)).as("edit " + n).isLessThan(0.5 / 255 / (1.055 / 2.4));
            }
            assertThat(refreshed).isTrue();
            try (Renderer fresh = renderer(Accuracy.RATIO)) {
                fresh.render(scene, Progress.NONE);
                assertThat(ErrorBound.of(renderer.cache()).maxError(renderer.cache())).as("the bound after a refresh")
                        .isEqualTo(ErrorBound.of(fresh.cache()).maxError(fresh.cache()));
                FilmAssert.assertSameBits(renderer.film(), fresh.film(), "refreshed");
            }
        }
    }

    private static double brightest(Renderer renderer) {
        double brightest = 0;
        for (float value : renderer.film().toScanlines()) {
            brightest = Math.max(brightest, value);
        }
        return brightest;
    }

    /** A slider moves between a thousandth and one repeatedly: the loss occurs once, not each time. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1e-6})
    void sliderUpAndDown_keepsBoundSmall(double min) {
        Scene scene = StudioScene.withFourLights(12, 10);
        try (Renderer renderer = renderer(Accuracy.RATIO)) {
            renderer.render(scene, Progress.NONE);
            for (int n = 0; n < 50; n++) {
                Scene edited = scene.withLight(scene.lights().getFirst().withIntensity(n % 2 == 0 ? min : 1));
                assertThat(renderer.render(edited, Progress.NONE).wasRefreshed()).as("refreshed at edit " + n).isFalse();
            }
        }
    }

    @Property(tries = 20)
    void firstFiftyOrdinaryEdits_neverRefresh(@ForAll long seed) {
        RandomEdits edits = new RandomEdits(seed);
        Scene scene = StudioScene.withFourLights(12, 10);
        try (Renderer renderer = renderer(Accuracy.RATIO)) {
            for (int n = 0; n < 50; n++) {
                assertThat(renderer.render(scene, Progress.NONE).wasRefreshed()).as("refreshed at edit " + n).isFalse();
                scene = edits.next(scene);
            }
        }
    }

    /** Over 60 · 60 · 3 = 10 800 values; after a refresh the bound is 0, as after a first pass. */
    @ParameterizedTest
    @CsvSource({"1,1", "1,7", "1,9", "10,10", "10,2", "50,50", "50,3", "100,100", "100,4"})
    void bound_isAtMostAHundredTimesTheLargestError(int count, long seed) {
        RandomEdits edits = new RandomEdits(seed);
        Scene scene = StudioScene.withFourLights(60, 60);
        try (Renderer renderer = renderer(Accuracy.RATIO)) {
            UpdateResult update = renderer.render(scene, Progress.NONE);
            for (int n = 0; n < count; n++) {
                scene = edits.next(scene);
                update = renderer.render(scene, Progress.NONE);
            }
            double error = FilmError.largestError(renderer.film(), new ReferenceTracer(scene).trace());
            assertThat(update.errorBound()).isBetween(error, 100 * error);
        }
    }
}
