package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.image.FilmAssert;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.junit.jupiter.api.Test;

class PlannedUpdateTest {
    private final Scene before = StudioScene.withFourLights(40, 30);
    private final Light light = before.lights().getFirst();
    private final Scene narrower = before.withLight(light.withAngle(light.angle() / 2));
    private final Scene moved =
            before.withLight(light.withPosition(light.position().times(0.5)).withDirection(light.direction().negated()));

    private Renderer renderer() {
        Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1));
        renderer.render(before, Progress.NONE);
        return renderer;
    }

    @Test
    void plannedUpdate_runsAsReported() {
        try (Renderer renderer = renderer()) {
            PlannedUpdate planned = renderer.plan(narrower);
            assertThat(renderer.render(planned, Progress.NONE).plan()).isSameAs(planned.update());
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(narrower).trace(), "as planned");
        }
    }

    @Test
    void planForOtherImage_isReplanned() {
        try (Renderer renderer = renderer()) {
            PlannedUpdate planned = renderer.plan(narrower);
            renderer.render(moved, Progress.NONE);
            renderer.render(planned, Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(narrower).trace(), "replanned");
        }
    }

    @Test
    void planBeforeClear_becomesFirstPass() {
        try (Renderer renderer = renderer()) {
            PlannedUpdate planned = renderer.plan(narrower);
            renderer.clear();
            assertThat(renderer.render(planned, Progress.NONE).plan()).isInstanceOf(UpdatePlan.FirstPass.class);
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(narrower).trace(), "first pass");
        }
    }
}
