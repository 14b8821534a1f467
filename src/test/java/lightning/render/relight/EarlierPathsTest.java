package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.PathUpdate;
import lightning.render.relight.plan.UpdatePlan;
import lightning.sample.IndirectScenes;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

/** Tests that an update can start from an earlier picture, so that the paths of its indirect light are kept. */
class EarlierPathsTest {
    private final Scene scene = IndirectScenes.all().get("room");
    private final Scene moved = scene.withLights(List.of(scene.lights().getFirst().withPosition(new Vec3(0, 0.5, 0))));

    private static Renderer rendered(Scene first, ReflectionMode mode) {
        Renderer renderer = new Renderer(RenderOptions.DEFAULT.withReflections(mode).withThreads(1));
        renderer.render(first, Progress.NONE);
        return renderer;
    }

    private static PathUpdate paths(PlannedUpdate planned) {
        return ((UpdatePlan.Relight) planned.update()).paths();
    }

    @Test
    void pathsOfEarlierPicture_areKept() {
        try (Renderer renderer = rendered(scene, ReflectionMode.CURRENT); WorkerPool workers = new WorkerPool(1)) {
            PixelCache earlier = renderer.cache();
            renderer.render(moved.withoutIndirect(), Progress.NONE);
            PlannedUpdate planned = renderer.planFrom(earlier, moved);
            assertThat(paths(planned)).isEqualTo(PathUpdate.KEEP);
            assertThat(renderer.render(planned, Progress.NONE).rays().gather()).isZero();
            FilmAssert.assertSameBits(renderer.film(), new TraditionalTracer(moved).trace(workers, Progress.NONE).film(), "earlier paths");
        }
    }

    @Test
    void pathsOfEarlierPicture_areRepeatedForOtherShapes() {
        Scene hidden = moved.withNodes(moved.nodes().subList(0, moved.nodes().size() - 1));
        try (Renderer renderer = rendered(scene, ReflectionMode.CURRENT); WorkerPool workers = new WorkerPool(1)) {
            PixelCache earlier = renderer.cache();
            renderer.render(hidden.withoutIndirect(), Progress.NONE);
            PlannedUpdate planned = renderer.planFrom(earlier, hidden);
            assertThat(paths(planned)).isEqualTo(PathUpdate.REPEAT);
            renderer.render(planned, Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), new TraditionalTracer(hidden).trace(workers, Progress.NONE).film(), "repeated");
        }
    }

    @Test
    void updateStartsFromNewestPicture_withoutEarlierPaths() {
        Scene denser = moved.withPicture(moved.picture().withIndirect(Optional.of(IndirectSettings.DEFAULT.withSpacing(8))));
        try (Renderer renderer = rendered(scene, ReflectionMode.CURRENT)) {
            PixelCache earlier = renderer.cache();
            renderer.render(moved.withoutIndirect(), Progress.NONE);
            assertThat(renderer.planFrom(null, moved).base()).isSameAs(renderer.cache());
            assertThat(renderer.planFrom(earlier, denser).base()).as("other settings").isSameAs(renderer.cache());
            assertThat(renderer.planFrom(earlier, moved).base()).isSameAs(earlier);
        }
    }

    /** The mirrors of the newest picture show another scene than the earlier one. */
    @Test
    void staleReflections_startFromNewestPicture() {
        try (Renderer renderer = rendered(scene, ReflectionMode.STALE)) {
            PixelCache earlier = renderer.cache();
            renderer.render(moved.withoutIndirect(), Progress.NONE);
            assertThat(renderer.planFrom(earlier, moved).base()).isSameAs(renderer.cache());
        }
    }
}
