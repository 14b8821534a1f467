package lightning.render.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.List;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Difference;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.RenderedScenes;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.render.trace.Geometry;
import lightning.sample.MixedEngineChoice;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests of a guarantee and the messages of images that satisfy or violate it. */
class VerificationTest {
    private static final Scene STUDIO = StudioScene.of(LightType.POINT);
    private static final Light KEY = STUDIO.lights().getFirst();
    private static final Scene DIM = STUDIO.withLight(KEY.withIntensity(0.3));

    private static Renderer renderer(Accuracy accuracy, ReflectionMode reflections) {
        return new Renderer(new RenderOptions(accuracy, reflections, MirrorStorage.FULL_ROWS, 1));
    }

    private static AccuracyGuarantee guarantee(Scene scene, Scene mirrored, double bound) {
        return new AccuracyGuarantee(new RenderedScenes(scene, mirrored), ViewEffects.ALL, bound);
    }

    private static Verification verify(AccuracyGuarantee promise, Film picture) {
        try (WorkerPool workers = new WorkerPool(1)) {
            return promise.verify(picture, workers, Progress.NONE);
        }
    }

    /** Returns an image that is brighter by 0.25 in one value. */
    private static Film withError(Film film) {
        Film off = film.copy();
        off.blue(0)[33] += 0.25f;
        return off;
    }

    @Test
    void guarantee_isBitExactOrBounded() {
        Film black = Film.black(2, 2);
        Film other = Film.black(2, 2);
        other.red(0)[0] = 0.25f;
        Difference none = Difference.of(black, black);
        Difference some = Difference.of(black, other);
        assertThat(guarantee(STUDIO, STUDIO, 0).isMetBy(none)).isTrue();
        assertThat(guarantee(STUDIO, STUDIO, 0).isMetBy(some)).isFalse();
        assertThat(guarantee(STUDIO, STUDIO, 0.25).isMetBy(some)).isTrue();
        assertThat(guarantee(STUDIO, STUDIO, 0.24).isMetBy(some)).isFalse();
    }

    @Test
    void text_statesBoundAndStaleMirrors() {
        assertThat(guarantee(STUDIO, STUDIO, 0).text()).isEqualTo("exact");
        assertThat(guarantee(DIM, STUDIO, 0).text()).isEqualTo("exact, reflections out of date");
        assertThat(guarantee(DIM, DIM, 1.21e-6).text()).as("rounded up").isEqualTo("off by at most 1.3e-06");
        Scene renamed = STUDIO.withLights(List.of(KEY.withName("rim")));
        assertThat(guarantee(renamed, STUDIO, 0).text()).as("not visible in the image").isEqualTo("exact");
        Scene matt = DIM.withPicture(DIM.picture().withDepth(0));
        assertThat(guarantee(matt, STUDIO.withPicture(matt.picture()), 0).text()).as("no mirrors").isEqualTo("exact");
    }

    @ParameterizedTest
    @EnumSource(Accuracy.class)
    void renderedPicture_meetsGuarantee(Accuracy accuracy) {
        try (Renderer renderer = renderer(accuracy, ReflectionMode.STALE)) {
            renderer.render(STUDIO, Progress.NONE);
            UpdateResult update = renderer.render(DIM, Progress.NONE);
            Verification verification = verify(AccuracyGuarantee.of(renderer, update), renderer.film());
            assertThat(verification.hasPassed()).isTrue();
            assertThat(verification.text()).startsWith("Verified: ").contains("with outdated reflections",
                    "would change with current reflections");
            assertThat(verification.full().hasSameBits(new ReferenceTracer(DIM).trace())).isTrue();
            assertThat(verification.currentDifference().pixels()).isPositive();
        }
    }

    @Test
    void fullTraceTime_isReportedOnlyWhenWarm() {
        Film film = new ReferenceTracer(STUDIO).trace();
        try {
            Engines.use(_ -> Engines.SCALAR);
            assertThat(verify(guarantee(STUDIO, STUDIO, 0), film).fullTraceMs()).isEmpty();
            Engines.use(Engines.FASTEST);
            assertThat(verify(guarantee(STUDIO, STUDIO, 0), film).fullTraceMs().getAsDouble()).isPositive();
        } finally {
            Engines.use(new MixedEngineChoice(2));
        }
    }

    @Test
    void metGuarantee_isReported() {
        Film film = new ReferenceTracer(STUDIO).trace();
        assertThat(verify(guarantee(STUDIO, STUDIO, 0), film).text()).isEqualTo("Verified: equal to a full trace in every bit");
        assertThat(verify(guarantee(STUDIO, STUDIO, 0.5), withError(film)).text())
                .isEqualTo("Verified: 1 value in 1 pixel differs from a full trace by at most 2.5e-01 (expected: at most 5.0e-01)");
    }

    @Test
    void violatedGuarantee_isReportedAndNotMeasured() {
        Film film = withError(new ReferenceTracer(STUDIO).trace());
        Verification broken = verify(guarantee(STUDIO, STUDIO, 0), film);
        assertThat(broken.hasPassed()).isFalse();
        assertThat(broken.text())
                .isEqualTo("Verification failed: 1 value in 1 pixel differs from a full trace by at most 2.5e-01 "
                        + "(expected: no difference)");
        assertThatThrownBy(() -> GuaranteeViolation.require(broken, AccuracySetting.EXACT)).isInstanceOf(GuaranteeViolation.class)
                .hasMessage("accuracy setting exact: " + broken.text() + "; not measured");
        assertThat(verify(guarantee(STUDIO, STUDIO, 0.2), film).text()).startsWith("Verification failed: ")
                .endsWith("(expected: at most 2.0e-01)");
        assertThatCode(() -> GuaranteeViolation.require(verify(guarantee(STUDIO, STUDIO, 0.3), film), AccuracySetting.RATIO))
                .doesNotThrowAnyException();
    }

    /** Empties the boxes of the renderer's BVH: a trace with the same BVH would be as wrong as the image. */
    @Test
    void wrongBvh_isDetected() throws ReflectiveOperationException {
        try (Renderer renderer = renderer(Accuracy.EXACT, ReflectionMode.CURRENT); WorkerPool workers = new WorkerPool(1)) {
            renderer.render(STUDIO, Progress.NONE);
            empty(renderer.cache().geometry());
            UpdateResult update = renderer.render(STUDIO.withPicture(STUDIO.picture().withSize(20, 16)), Progress.NONE);
            Film overTheSameTree =
                    new TraditionalTracer(renderer.scene(), renderer.cache().geometry()).trace(workers, Progress.NONE).film();
            assertThat(overTheSameTree.hasSameBits(renderer.film())).isTrue();
            assertThat(verify(AccuracyGuarantee.of(renderer, update), renderer.film()).hasPassed()).isFalse();
        }
    }

    private static void empty(Geometry geometry) throws ReflectiveOperationException {
        var tree = Geometry.class.getDeclaredField("bvh");
        tree.setAccessible(true);
        var boxes = tree.getType().getDeclaredField("boxes");
        boxes.setAccessible(true);
        Arrays.fill((float[]) boxes.get(tree.get(geometry)), Float.NaN);
    }
}
