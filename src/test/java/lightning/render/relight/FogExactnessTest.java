package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.EditSession;
import lightning.sample.MixedEngineChoice;
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

/** Tests that fog in mirrors and behind glass has the bits of a reference trace after every edit, with current and outdated reflections. */
class FogExactnessTest {
    @Provide
    Arbitrary<EditSession> sessions() {
        return EditSession.fogSessions();
    }

    @Provide
    Arbitrary<Set<RenderEffect>> effects() {
        return Arbitraries.of(RenderEffect.ALL).set();
    }

    private static RenderOptions options(ReflectionMode reflections, MirrorStorage storage, int threads, long engines) {
        return new RenderOptions(Accuracy.EXACT, reflections, storage, threads).withEngines(new MixedEngineChoice(engines));
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void fogInMirrors_equalsReferenceAfterEveryEdit(@ForAll("sessions") EditSession session, @ForAll MirrorStorage storage,
            @ForAll @IntRange(min = 1, max = 3) int threads, @ForAll("effects") Set<RenderEffect> forced, @ForAll long engines) {
        RenderOptions options = new RenderOptions(Accuracy.EXACT, ReflectionMode.CURRENT, storage, threads,
                ViewEffects.ALL.withForced(forced)).withEngines(new MixedEngineChoice(engines));
        SessionAssert.assertExactAfterEveryEdit("fog-in-mirrors", session, options, scene -> new ReferenceTracer(scene).trace());
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void fogInOutdatedMirrors_equalsReferenceOfBothScenes(@ForAll("sessions") EditSession session, @ForAll MirrorStorage storage,
            @ForAll @IntRange(min = 1, max = 4) int refreshEach, @ForAll long engines) {
        try (Renderer renderer = new Renderer(options(ReflectionMode.STALE, storage, 1, engines))) {
            for (int step : session.steps()) {
                UpdateResult update = renderer.render(session.scenes().get(step), Progress.NONE);
                SessionAssert.assertSameBits(renderer.film(), ReferenceCheck.referenceFilm(renderer.cache()), "fog-in-outdated-mirrors",
                        session, step, update.plan().description());
                if (step % refreshEach == 0) {
                    renderer.updateReflections(Progress.NONE);
                    SessionAssert.assertSameBits(renderer.film(), ReferenceCheck.referenceFilm(renderer.cache()), "fog-in-mirrors-updated",
                            session, step, "reflections");
                }
            }
        }
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void fullTraceOfFogInMirrors_equalsReference(@ForAll("sessions") EditSession session) {
        Scene scene = session.scenes().getLast();
        try (WorkerPool workers = new WorkerPool(2)) {
            assertThat(new TraditionalTracer(scene).trace(workers, Progress.NONE).film().hasSameBits(new ReferenceTracer(scene).trace()))
                    .as(session.toString()).isTrue();
        }
    }
}
