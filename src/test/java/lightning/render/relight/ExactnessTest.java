package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import lightning.base.work.Progress;
import lightning.bench.accuracy.Promise;
import lightning.render.image.Film;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.MirrorStorage;
import lightning.render.relight.tile.Options;
import lightning.render.shading.ReferenceTracer;
import lightning.render.shading.SceneCoverage;
import lightning.render.shading.TraceCounts;
import lightning.sample.ClearScenes;
import lightning.sample.EngineMix;
import lightning.sample.Session;
import lightning.sample.Slow;
import lightning.scene.PlacedShape;
import lightning.scene.Rig;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.effects.Effect;
import lightning.scene.effects.ViewEffects;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.statistics.Statistics;
import net.jqwik.api.statistics.StatisticsReport;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * At accuracy exact every picture has the bits of a reference trace, whatever edits led to it, and whether the work that the
 * scene does not call for is left out or done, whichever engines its tiles come from.
 */
class ExactnessTest {

    @Provide
    Arbitrary<Session> sessions() {
        return Session.sessions();
    }

    @Provide
    Arbitrary<Session> extremes() {
        return Session.extremes();
    }

    @Provide
    Arbitrary<Set<Effect>> effects() {
        return Arbitraries.of(Effect.ALL).set();
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    @StatisticsReport(onFailureOnly = true)
    void currentReflections_equalTheReferenceAfterEveryEdit(@ForAll("sessions") Session session,
            @ForAll MirrorStorage storage, @ForAll @IntRange(min = 1, max = 3) int threads, @ForAll("effects") Set<Effect> forced,
            @ForAll long engines) {
        SceneCoverage.collect(session.scenes().getFirst());
        assertEqualsTheReference("current-reflections", session, new Options(Accuracy.EXACT, Reflections.CURRENT, storage, threads,
                ViewEffects.ALL.forcing(forced)).withEngines(new EngineMix(engines)));
    }

    private static void assertEqualsTheReference(String name, Session session, Options options) {
        try (Renderer renderer = new Renderer(options)) {
            for (int step = 0; step < session.scenes().size(); step++) {
                Scene scene = session.scenes().get(step);
                Update update = renderer.render(scene, Progress.NONE);
                SessionAssert.assertSameBits(renderer.film(), new ReferenceTracer(scene).trace(), name, session, step,
                        update.plan().text());
                assertThat(Promise.of(renderer, update).text()).isEqualTo("exact");
            }
        }
    }

    /** Every attribute at any magnitude that it may have, in lights and materials that were drawn likewise. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    @Slow
    void extremeScenes_equalTheReferenceAfterEveryEdit(@ForAll("extremes") Session session, @ForAll long engines) {
        assertEqualsTheReference("extreme-scenes", session,
                new Options(Accuracy.EXACT, Reflections.CURRENT, MirrorStorage.FULL_ROWS, 1).withEngines(new EngineMix(engines)));
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    @Slow
    void staleReflections_showTheSceneOfTheirLastUpdate(@ForAll("sessions") Session session,
            @ForAll @IntRange(min = 1, max = 7) int refreshEach, @ForAll MirrorStorage storage,
            @ForAll @IntRange(min = 1, max = 3) int threads, @ForAll("effects") Set<Effect> forced,
            @ForAll long engines) {
        Options options = new Options(Accuracy.EXACT, Reflections.STALE, storage, threads, ViewEffects.ALL.forcing(forced))
                .withEngines(new EngineMix(engines));
        try (Renderer renderer = new Renderer(options)) {
            Scene before = session.scenes().getFirst();
            Scene mirrored = before;
            for (int step = 0; step < session.scenes().size(); step++) {
                Scene scene = session.scenes().get(step);
                Update update = renderer.render(scene, Progress.NONE);
                // What is forced may change what normals are bent by.
                mirrored = refreshesReflections(options.view().of(before), options.view().of(scene)) ? scene : mirrored;
                SessionAssert.assertSameBits(renderer.film(), new ReferenceTracer(scene, mirrored).trace(),
                        "stale-reflections", session, step, update.plan().text());
                assertStatementHolds(Promise.of(renderer, update), renderer, session, step);
                if (step % refreshEach == refreshEach - 1) {
                    Update updated = renderer.updateReflections(Progress.NONE);
                    mirrored = scene;
                    SessionAssert.assertSameBits(renderer.film(), new ReferenceTracer(scene).trace(),
                            "updated-reflections", session, step, "reflections");
                    assertThat(Promise.of(renderer, updated).text()).isEqualTo("exact");
                }
                assertThat(renderer.reflectionsAreCurrent()).isEqualTo(options.view().of(mirrored).equals(options.view().of(scene)));
                before = scene;
            }
        }
    }

    /** A picture that is called exact has the bits of a full trace; where nothing bounces rays, none is called stale. */
    private static void assertStatementHolds(Promise promise, Renderer renderer, Session session, int step) {
        Scene scene = session.scenes().get(step);
        boolean bounces = scene.picture().depth() > 0 && scene.placedShapes().stream().map(PlacedShape::material)
                .anyMatch(m -> m.reflective().max() > 0 || m.clarity().clear().max() > 0);
        assertThat(bounces || !promise.isStale()).as(session.toString()).isTrue();
        assertThat(promise.text()).isEqualTo(promise.isStale() ? "exact, reflections of an older light" : "exact");
        Statistics.label("statement").collect(promise.isStale() ? "stale" : "exact");
        if (!promise.isStale()) {
            SessionAssert.assertSameBits(renderer.film(), new ReferenceTracer(scene).trace(), "called-exact", session, step,
                    promise.text());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {ClearScenes.BALL, ClearScenes.PANE})
    void lightSeenThroughClearShapesAlone_isCalledStaleUntilItIsUpdated(String text) {
        Scene scene = ClearScenes.scene(text);
        Scene dim = scene.withLight(scene.lights().getFirst().withIntensity(0.3));
        try (Renderer renderer = new Renderer(Options.DEFAULT.withReflections(Reflections.STALE).withThreads(1))) {
            renderer.render(scene, Progress.NONE);
            Promise edited = Promise.of(renderer, renderer.render(dim, Progress.NONE));
            assertThat(renderer.film().sameBits(new ReferenceTracer(dim).trace())).as("glass shows the older light").isFalse();
            assertThat(edited.text()).isEqualTo("exact, reflections of an older light");
            Promise updated = Promise.of(renderer, renderer.updateReflections(Progress.NONE));
            assertThat(renderer.film().sameBits(new ReferenceTracer(dim).trace())).isTrue();
            assertThat(updated.text()).isEqualTo("exact");
        }
    }

    /** Edits of depth and size, of where rays can hit something, and of the normals and ways there, bring the mirror images up to date. */
    private static boolean refreshesReflections(Scene before, Scene scene) {
        return !before.picture().equals(scene.picture()) || !before.camera().equals(scene.camera())
                || !before.nodes().equals(scene.nodes()) || !haveSameWays(before, scene);
    }

    /** Of scenes with the same shapes. */
    private static boolean haveSameWays(Scene before, Scene scene) {
        return scene.stage().namedMaterials().stream().allMatch(name -> before.materialsByName().get(name)
                .hasWaysOf(scene.materialsByName().get(name)));
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void theRenderedSceneAgain_costsNothing(@ForAll("sessions") Session session, @ForAll Reflections reflections) {
        try (Renderer renderer = new Renderer(new Options(Accuracy.EXACT, reflections, MirrorStorage.FULL_ROWS, 1))) {
            Scene rendered = session.scenes().getFirst();
            renderer.render(rendered, Progress.NONE);
            Film film = renderer.film().copy();
            for (Scene edited : session.scenes()) {
                renderer.plan(edited);
            }
            Update update = renderer.render(copy(rendered), Progress.NONE);
            assertThat(update.plan()).isEqualTo(new UpdatePlan.Nothing());
            assertThat(update.rays()).isEqualTo(TraceCounts.NONE);
            assertThat(update.rowsTouched() + update.rowsComposed()).isZero();
            assertThat(renderer.film().sameBits(film)).isTrue();
        }
    }

    /** An equal scene that shares no list with the given one. */
    private static Scene copy(Scene s) {
        return new Scene(s.picture().withDepth(s.picture().depth()), s.camera(), s.world(),
                new Stage(List.copyOf(s.materials().reversed()).reversed(), List.copyOf(s.nodes().reversed()).reversed()),
                Rig.of(s.lights().stream().map(l -> l.withName(l.name())).toList(), List.copyOf(s.rig().banks().reversed()).reversed()));
    }
}
