package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Progress;
import lightning.render.cache.PixelCache;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.RenderOptions;
import lightning.render.relight.tile.RepeatedEditDetector;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
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

    /** A drag caches partial sums of the other lights from its second edit on; a restored renderer has not seen the first. */
    @Test
    void restoredRenderer_hasNoRepeatedEdit() {
        List<Light> lights = new ArrayList<>();
        for (int i = 0; i < RepeatedEditDetector.MIN_LIGHTS; i++) {
            lights.add(StudioScene.key(LightType.POINT).withName("light" + i));
        }
        Scene many = before.withLights(lights);
        Scene edited = many.withLight(lights.getFirst().withIntensity(0.5));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withReflections(ReflectionMode.STALE).withThreads(1))) {
            renderer.render(many, Progress.NONE);
            PixelCache saved = renderer.cache();
            renderer.render(edited, Progress.NONE);
            renderer.restore(saved);
            renderer.render(edited, Progress.NONE);
            for (int tile = 0; tile < renderer.cache().tileCount(); tile++) {
                assertThat(renderer.cache().tile(tile).levels[0].branches()).as("tile " + tile).isNull();
            }
        }
    }
}
