package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.RenderedScenes;
import lightning.render.shading.SceneCoverage;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.render.trace.Geometry;
import lightning.sample.EditSession;
import lightning.sample.StudioScene;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.Size;
import net.jqwik.api.statistics.StatisticsReport;
import org.junit.jupiter.api.Test;

/** Tests that pixel centers first and finer samples later give a finished picture with the same bits. */
class DeferredSamplesTest {
    /** Actions after the centers of an edit are finished. */
    enum NextAction {
        FINISH, LEAVE, CANCEL, RENDER, REFLECT
    }

    @Provide
    Arbitrary<EditSession> sessions() {
        return EditSession.mixedSessions();
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    @StatisticsReport(onFailureOnly = true)
    void deferredSamples_equalSingleUpdate(@ForAll("sessions") EditSession session, @ForAll MirrorStorage storage,
            @ForAll ReflectionMode reflections, @ForAll Accuracy accuracy, @ForAll @Size(13) List<NextAction> actions,
            @ForAll boolean edges) {
        RenderOptions options = new RenderOptions(accuracy, reflections, storage, 2);
        int followed = 0;
        try (Renderer immediate = new Renderer(options); Renderer later = new Renderer(options)) {
            for (int step : session.steps()) {
                Scene scene = edges ? sampled(session.scenes().get(step), new SamplingSettings(AntialiasMode.EDGES, 2))
                        : session.scenes().get(step);
                immediate.render(scene, Progress.NONE);
                UpdateResult update = later.renderCenters(later.plan(scene), Progress.NONE);
                boolean finished = later.state().isFinished();
                followed += finished ? 0 : 1;
                if (!finished) {
                    SessionAssert.assertSameBits(later.film(), centers(later.cache().scenes()), "centers-first", session, step,
                            update.plan().description());
                }
                apply(actions.get(step), immediate, later, scene);
                if (later.state().isFinished()) {
                    SessionAssert.assertSameBits(later.film(), immediate.film(), "samples-later", session, step,
                            update.plan().description());
                }
            }
            if (!later.state().isFinished()) {
                later.finish(Progress.NONE);
            }
            SessionAssert.assertSameBits(later.film(), immediate.film(), "samples-last", session, session.scenes().size() - 1, "finish");
            SceneCoverage.collect("samples updated from the finished picture", followed > 0, 15);
        }
    }

    private static void apply(NextAction action, Renderer immediate, Renderer later, Scene scene) {
        switch (action) {
            case LEAVE -> {}
            case FINISH -> {
                if (!later.state().isFinished()) {
                    later.finish(Progress.NONE);
                }
            }
            case CANCEL -> {
                if (!later.state().isFinished()) {
                    Film before = later.film().copy();
                    assertThatThrownBy(() -> later.finish(new CancelingProgress(0))).isInstanceOf(CancellationException.class);
                    FilmAssert.assertSameBits(later.film(), before, "samples-canceled");
                }
            }
            case RENDER -> later.render(scene, Progress.NONE);
            case REFLECT -> {
                immediate.updateReflections(Progress.NONE);
                later.updateReflections(Progress.NONE);
            }
        }
    }

    private static Scene sampled(Scene scene, SamplingSettings sampling) {
        return scene.withPicture(scene.picture().withSampling(sampling));
    }

    private static Film centers(RenderedScenes scenes) {
        Scene scene = sampled(scenes.scene(), SamplingSettings.DEFAULT);
        try (var workers = new WorkerPool(1)) {
            return new TraditionalTracer(scene, sampled(scenes.mirrored(), SamplingSettings.DEFAULT), Geometry.of(scene))
                    .trace(workers, Progress.NONE).film();
        }
    }

    private static Scene studio() {
        Scene scene = StudioScene.of(LightType.POINT);
        return scene.withPicture(scene.picture().withSize(70, 50).withSampling(new SamplingSettings(AntialiasMode.EDGES, 2)));
    }

    private static Scene key(double intensity, boolean on) {
        Light key = studio().light(StudioScene.KEY).orElseThrow();
        return studio().withLight(key.withIntensity(intensity).withOn(on));
    }

    private static UpdateResult centers(Renderer renderer, Scene scene) {
        return renderer.renderCenters(renderer.plan(scene), Progress.NONE);
    }

    @Test
    void editBeforeFirstSamples_retracesNoCenter() {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            centers(renderer, studio());
            UpdateResult edit = centers(renderer, key(0.5, true));
            assertThat(edit.plan()).isInstanceOf(UpdatePlan.Relight.class);
            assertThat(edit.rays().total()).isZero();
            renderer.finish(Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(key(0.5, true)).trace(), "edit-before-samples");
        }
    }

    @Test
    void firstSamplesAfterEdit_reportEdit() {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            UpdateResult first = centers(renderer, studio());
            UpdateResult edit = centers(renderer, key(0.5, true));
            UpdateResult finished = renderer.finish(Progress.NONE);
            assertThat(finished.plan()).isEqualTo(edit.plan());
            assertThat(first.plan()).isInstanceOf(UpdatePlan.FirstPass.class);
            assertThat(finished.rays().eye()).as("rays of the samples only").isPositive().isEqualTo(firstSamples());
        }
    }

    /** Returns the camera rays of the samples without those of the centers. */
    private static long firstSamples() {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            return renderer.render(key(0.5, true), Progress.NONE).rays().eye() - 70L * 50;
        }
    }

    @Test
    void finish_reportsAllWorkSinceLastFinishedImage() {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT); Renderer immediate = new Renderer(RenderOptions.DEFAULT)) {
            renderer.render(studio(), Progress.NONE);
            immediate.render(studio(), Progress.NONE);
            centers(renderer, key(0.5, true));
            UpdateResult whole = immediate.render(key(0.5, true), Progress.NONE);
            UpdateResult finished = renderer.finish(Progress.NONE);
            assertThat(finished.plan()).isEqualTo(whole.plan());
            assertThat(finished.rowsTouched()).isEqualTo(whole.rowsTouched());
            assertThat(finished.rowsComposed()).isEqualTo(whole.rowsComposed());
            assertThat(finished.bytesMoved()).isEqualTo(whole.bytesMoved());
        }
    }

    @Test
    void weightEditThatKeepsEdges_isFinishedAtOnce() {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            renderer.render(key(0.5, true), Progress.NONE);
            centers(renderer, key(0.55, true));
            assertThat(renderer.state().isFinished()).isTrue();
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(key(0.55, true)).trace(), "weight-edit");
        }
    }

    @Test
    void undoneEditBeforeSamples_restoresFinishedImage() {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            renderer.render(studio(), Progress.NONE);
            Film before = renderer.film();
            centers(renderer, key(0.5, true));
            UpdateResult back = centers(renderer, studio());
            assertThat(back.plan()).isInstanceOf(UpdatePlan.Nothing.class);
            assertThat(renderer.state().isFinished()).isTrue();
            assertThat(renderer.film().red(0)).isSameAs(before.red(0));
        }
    }

    @Test
    void lightMovedAndSwitchedOff_returnsAtNewPosition() {
        Light key = studio().light(StudioScene.KEY).orElseThrow();
        Light there = key.withPosition(key.position().times(0.7));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            renderer.render(studio(), Progress.NONE);
            centers(renderer, studio().withLight(there));
            centers(renderer, studio().withLight(there.withOn(false)));
            renderer.finish(Progress.NONE);
            Scene lit = studio().withLight(there);
            renderer.render(lit, Progress.NONE);
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(lit).trace(), "moved-out-and-back");
        }
    }

    @Test
    void undoneDepthBeforeSamples_keepsCurrentMirrors() {
        Scene lit = key(0.5, true);
        Scene dark = key(0.5, false);
        RenderOptions options = RenderOptions.DEFAULT.withReflections(ReflectionMode.STALE);
        try (Renderer later = new Renderer(options); Renderer immediate = new Renderer(options)) {
            for (Renderer renderer : List.of(later, immediate)) {
                renderer.render(studio(), Progress.NONE);
                renderer.render(lit, Progress.NONE);
                renderer.render(dark, Progress.NONE);
                // Mirrors show that the light is off, but its cached layer there has the intensity before.
                renderer.updateReflections(Progress.NONE);
            }
            for (Scene scene : List.of(dark.withPicture(dark.picture().withDepth(0)), lit)) {
                centers(later, scene);
                immediate.render(scene, Progress.NONE);
            }
            if (!later.state().isFinished()) {
                later.finish(Progress.NONE);
            }
            assertThat(later.cache().hasCurrentReflections()).isEqualTo(immediate.cache().hasCurrentReflections()).isTrue();
            FilmAssert.assertSameBits(later.film(), immediate.film(), "depth-and-back");
            FilmAssert.assertSameBits(later.film(), new ReferenceTracer(lit).trace(), "depth-and-back");
        }
    }

    @Test
    void changedAccuracyBeforeSamples_updatesFinishedImage() {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            renderer.render(studio(), Progress.NONE);
            centers(renderer, key(0.5, true));
            renderer.setOptions(RenderOptions.DEFAULT.withAccuracy(Accuracy.RATIO));
            UpdateResult update = centers(renderer, key(0.5, true));
            assertThat(update.plan()).isInstanceOf(UpdatePlan.Relight.class);
            assertThat(renderer.state().isFinished()).isTrue();
        }
    }

    @Test
    void imageWithoutEdgeSamples_isFinishedImmediately() {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            for (AntialiasMode antialias : List.of(AntialiasMode.OFF, AntialiasMode.EVERY)) {
                centers(renderer, sampled(studio(), new SamplingSettings(antialias, 2)));
                assertThat(renderer.state().isFinished()).isTrue();
            }
            assertThatThrownBy(() -> renderer.finish(Progress.NONE)).isInstanceOf(IllegalStateException.class);
        }
    }

    /** Samples of the finished picture have reflections of the scene before the depth changed, so they cannot follow the centers. */
    @Test
    void editAfterDepthWithStaleMirrors_rendersSamplesBetween() {
        Scene shallow = key(0.5, true).withPicture(studio().picture().withDepth(1));
        Light key = shallow.light(StudioScene.KEY).orElseThrow();
        Scene last = shallow.withLight(key.withIntensity(0.2));
        RenderOptions options = RenderOptions.DEFAULT.withReflections(ReflectionMode.STALE);
        try (Renderer renderer = new Renderer(options)) {
            renderer.render(studio(), Progress.NONE);
            for (Scene scene : List.of(key(0.5, true), shallow, last)) {
                centers(renderer, scene);
            }
            renderer.finish(Progress.NONE);
            assertThat(renderer.cache().mirrored().scene()).isEqualTo(shallow);
            FilmAssert.assertSameBits(renderer.film(), new ReferenceTracer(last, shallow).trace(), "depth-between-edits");
        }
    }

    @Test
    void state_countsCentersAndFinishedPicture() {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            assertThat(renderer.state().bytes()).isZero();
            renderer.render(studio(), Progress.NONE);
            long finished = MemoryEstimate.usedBytes(renderer.cache());
            assertThat(renderer.state().bytes()).isEqualTo(finished);
            centers(renderer, key(0.5, true));
            assertThat(renderer.state().bytes()).isEqualTo(finished + MemoryEstimate.usedBytes(renderer.cache()));
        }
    }
}
