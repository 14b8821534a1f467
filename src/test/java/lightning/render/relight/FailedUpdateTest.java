package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.stream.Stream;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Film;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.TransparentScenes;
import lightning.scene.Scene;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Tests that a failed update leaves the cache unchanged, pending samples included. */
class FailedUpdateTest {
    private static final String TEXT = """
            jen 1
            picture { size 60 40  antialias edges  samples 2 }
            camera { from 0 1 6  to 0 0 0 }
            sphere left { at -1 0 0 }
            sphere middle {}
            sphere right { at 1 0 0 }
            light lamp point { at 2 3 2 }
            """;
    private static final Scene ALL = TransparentScenes.scene(TEXT);
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);

    private final Renderer renderer = new Renderer(OPTIONS);

    @AfterEach
    void close() {
        renderer.close();
    }

    private static Scene sceneWith(String... shapes) {
        return ALL.withNodes(ALL.nodes().stream().filter(n -> List.of(shapes).contains(n.name())).toList());
    }

    /** At accuracy ratio a refresh follows an update if an error would be visible. */
    @Test
    void failedUpdate_keepsPreviousImage() {
        Scene dim = ALL.withLight(ALL.lights().getFirst().withIntensity(0.3));
        renderer.setOptions(OPTIONS.withAccuracy(Accuracy.RATIO));
        renderer.setView(160, DisplayCurve.SRGB);
        renderer.render(ALL, Progress.NONE);
        PixelCache known = renderer.cache();
        UpdateResult done = null;
        int checks = 0;
        while (done == null) {
            try {
                done = renderer.render(dim, new FailingProgress(checks, OutOfMemoryError::new));
            } catch (OutOfMemoryError e) {
                assertThat(renderer.cache()).as("after %s checks", checks).isSameAs(known);
                checks++;
            }
        }
        assertThat(checks).isGreaterThan(2);
        assertThat(done.wasRefreshed()).isTrue();
    }

    /**
     * The centers contain a shape of the target scene; the finished picture, from which samples follow, does not and needs a first
     * pass.
     */
    @Test
    void rejectedFirstPass_keepsCentersAndPendingSamples() {
        Scene centers = sceneWith("left", "right");
        Scene target = sceneWith("right");
        renderer.render(sceneWith("left"), Progress.NONE);
        renderer.renderCenters(renderer.plan(centers), Progress.NONE);
        PixelCache known = renderer.cache();
        PixelCache finished = renderer.state().lastFinished();
        Film film = renderer.film().copy();
        assertThat(renderer.state().isFinished()).isFalse();
        assertThat(renderer.plan(target).update()).isInstanceOf(UpdatePlan.FirstPass.class);
        renderer.setOptions(OPTIONS.withMemory(1));
        Stream.<Runnable>of(() -> renderer.render(target, Progress.NONE),
                () -> renderer.renderCenters(renderer.plan(target), Progress.NONE)).forEach(refused -> {
                    assertThatThrownBy(refused::run).isInstanceOf(PictureTooLargeException.class);
                    assertThat(renderer.cache()).isSameAs(known);
                    assertThat(renderer.state().lastFinished()).isSameAs(finished);
                    assertThat(renderer.state().isFinished()).isFalse();
                    assertThat(renderer.film().hasSameBits(film)).isTrue();
                });
        renderer.finish(Progress.NONE);
        assertThat(renderer.film().hasSameBits(new ReferenceTracer(centers).trace())).isTrue();
        renderer.setOptions(OPTIONS);
        renderer.render(target, Progress.NONE);
        assertThat(renderer.film().hasSameBits(new ReferenceTracer(target).trace())).isTrue();
    }
}
