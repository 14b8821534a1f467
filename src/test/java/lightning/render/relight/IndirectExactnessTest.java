package lightning.render.relight;

import java.util.Set;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.trace.Geometry;
import lightning.sample.EditSession;
import lightning.sample.MixedEngineChoice;
import lightning.sample.Slow;
import lightning.scene.Scene;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.ViewEffects;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;

/** Tests that pictures with indirect light equal full traces in every bit after all sequences of edits. */
class IndirectExactnessTest {

    @Provide
    Arbitrary<EditSession> sessions() {
        return EditSession.indirectSessions();
    }

    @Provide
    Arbitrary<Set<RenderEffect>> effects() {
        return Arbitraries.of(RenderEffect.ALL).set();
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void currentReflections_equalFullTraceAfterEveryEdit(@ForAll("sessions") EditSession session, @ForAll MirrorStorage storage,
            @ForAll @IntRange(min = 1, max = 3) int threads, @ForAll("effects") Set<RenderEffect> forced, @ForAll long engines) {
        RenderOptions options =
                new RenderOptions(Accuracy.EXACT, ReflectionMode.CURRENT, storage, threads, ViewEffects.ALL.withForced(forced))
                        .withEngines(new MixedEngineChoice(engines));
        SessionAssert.assertExactAfterEveryEdit("indirect-current", session, options, scene -> fullTrace(scene, scene));
    }

    @Provide
    Arbitrary<EditSession> objectSessions() {
        return EditSession.indirectObjectSessions();
    }

    /** Most rays meet no changed object, so they are taken from the last picture. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    void editedObjects_equalFullTraceAfterEveryEdit(@ForAll("objectSessions") EditSession session, @ForAll MirrorStorage storage,
            @ForAll @IntRange(min = 1, max = 3) int threads, @ForAll long engines) {
        RenderOptions options = new RenderOptions(Accuracy.EXACT, ReflectionMode.CURRENT, storage, threads)
                .withEngines(new MixedEngineChoice(engines));
        SessionAssert.assertExactAfterEveryEdit("indirect-objects", session, options, scene -> fullTrace(scene, scene));
    }

    @Provide
    Arbitrary<EditSession> environmentSessions() {
        return EditSession.environmentSessions();
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void environment_equalsFullTraceAfterEveryEdit(@ForAll("environmentSessions") EditSession session, @ForAll MirrorStorage storage,
            @ForAll @IntRange(min = 1, max = 3) int threads, @ForAll long engines) {
        RenderOptions options = new RenderOptions(Accuracy.EXACT, ReflectionMode.CURRENT, storage, threads)
                .withEngines(new MixedEngineChoice(engines));
        SessionAssert.assertExactAfterEveryEdit("environment", session, options, scene -> fullTrace(scene, scene));
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    @Slow
    void staleReflections_showLastUpdatedScene(@ForAll("sessions") EditSession session, @ForAll @IntRange(min = 1, max = 7) int refreshEach,
            @ForAll MirrorStorage storage, @ForAll @IntRange(min = 1, max = 3) int threads, @ForAll long engines) {
        RenderOptions options = new RenderOptions(Accuracy.EXACT, ReflectionMode.STALE, storage, threads)
                .withEngines(new MixedEngineChoice(engines));
        try (Renderer renderer = new Renderer(options)) {
            Scene before = session.scenes().getFirst();
            Scene mirrored = before;
            for (int step : session.steps()) {
                Scene scene = session.scenes().get(step);
                UpdateResult update = renderer.render(scene, Progress.NONE);
                mirrored = ExactnessTest.refreshesReflections(before, scene) ? scene : mirrored;
                SessionAssert.assertSameBits(renderer.film(), fullTrace(scene, mirrored), "indirect-stale", session, step,
                        update.plan().description());
                if (step % refreshEach == refreshEach - 1) {
                    renderer.updateReflections(Progress.NONE);
                    mirrored = scene;
                    SessionAssert.assertSameBits(renderer.film(), fullTrace(scene, scene), "indirect-updated", session, step,
                            "reflections");
                }
                before = scene;
            }
        }
    }

    private static Film fullTrace(Scene scene, Scene mirrored) {
        try (WorkerPool workers = new WorkerPool(1)) {
            return new TraditionalTracer(scene, mirrored, Geometry.of(scene)).trace(workers, Progress.NONE).film();
        }
    }
}
