package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

/** Tests restoring the cache of an earlier picture. */
class RestoreTest {
    private final Scene before = StudioScene.withFourLights(40, 30);
    private final Scene after = before.withLight(before.lights().getFirst().withAngle(10).withIntensity(0.2));

    @Test
    void restoredRenderer_repeatsEdit() {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1).withReflections(ReflectionMode.CURRENT))) {
            renderer.render(before, Progress.NONE);
            PixelCache saved = renderer.cache();
            UpdateResult first = renderer.render(after, Progress.NONE);
            renderer.restore(saved);
            assertThat(renderer.scene()).isEqualTo(before);
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(before).trace(), "restored");
            UpdateResult second = renderer.render(after, Progress.NONE);
            assertThat(second.plan()).isEqualTo(first.plan());
            assertThat(second.rowsTouched()).isEqualTo(first.rowsTouched());
            assertThat(second.bytesMoved()).isEqualTo(first.bytesMoved());
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(after).trace(), "edited again");
        }
    }

    @Test
    void cachedRows_workWithCurrentReflections() {
        try (Renderer stale = new Renderer(RenderOptions.DEFAULT.withReflections(ReflectionMode.STALE).withThreads(1));
                Renderer current = new Renderer(RenderOptions.DEFAULT.withThreads(1).withReflections(ReflectionMode.CURRENT))) {
            stale.render(before, Progress.NONE);
            current.restore(stale.cache());
            assertThat(current.render(after, Progress.NONE).plan()).isInstanceOf(UpdatePlan.Relight.class);
            FilmAssert.assertSameBits(current.film(), new ReferenceTracer(after).trace(), "taken over");
        }
    }
}
