package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.measure.AccuracyGuarantee;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.RayCounts;
import lightning.render.shading.SceneCoverage;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.EditSession;
import lightning.sample.MixedEngineChoice;
import lightning.sample.Slow;
import lightning.sample.TransparentScenes;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.ViewEffects;
import lightning.scene.light.LightRig;
import lightning.scene.material.Material;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tuple;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.statistics.Statistics;
import net.jqwik.api.statistics.StatisticsReport;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests that at accuracy exact every picture has the bits of a reference trace, for all sequences of edits, for required and forced
 * work, and for all engines.
 */
class ExactnessTest {

    /** Weight of sessions with indirect light, whose reference is slow, to 19 without. */
    private static final int INDIRECT = Integer.getInteger("lightning.test.indirect", 1);

    @Provide
    Arbitrary<EditSession> sessions() {
        return Arbitraries.frequencyOf(Tuple.of(19, EditSession.sessions()), Tuple.of(INDIRECT, EditSession.indirectSessions()));
    }

    @Provide
    Arbitrary<EditSession> extremes() {
        return EditSession.extremeSessions();
    }

    @Provide
    Arbitrary<Set<RenderEffect>> effects() {
        return Arbitraries.of(RenderEffect.ALL).set();
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    @StatisticsReport(onFailureOnly = true)
    void currentReflections_equalReferenceAfterEveryEdit(@ForAll("sessions") EditSession session,
            @ForAll MirrorStorage storage, @ForAll @IntRange(min = 1, max = 3) int threads, @ForAll("effects") Set<RenderEffect> forced,
            @ForAll long engines) {
        SceneCoverage.collect(session.scenes().getFirst());
        assertEqualsReference("current-reflections", session, new RenderOptions(Accuracy.EXACT, ReflectionMode.CURRENT, storage, threads,
                ViewEffects.ALL.withForced(forced)).withEngines(new MixedEngineChoice(engines)));
    }

    private static void assertEqualsReference(String name, EditSession session, RenderOptions options) {
        SessionAssert.assertExactAfterEveryEdit(name, session, options, scene -> new ReferenceTracer(scene).trace());
    }

    /** Draws every attribute at any valid magnitude, in random lights and materials. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    @Slow
    void extremeScenes_equalReferenceAfterEveryEdit(@ForAll("extremes") EditSession session, @ForAll long engines) {
        assertEqualsReference("extreme-scenes", session,
                new RenderOptions(Accuracy.EXACT, ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, 1)
                        .withEngines(new MixedEngineChoice(engines)));
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    @Slow
    void staleReflections_showLastUpdatedScene(@ForAll("sessions") EditSession session,
            @ForAll @IntRange(min = 1, max = 7) int refreshEach, @ForAll MirrorStorage storage,
            @ForAll @IntRange(min = 1, max = 3) int threads, @ForAll("effects") Set<RenderEffect> forced,
            @ForAll long engines) {
        RenderOptions options =
                new RenderOptions(Accuracy.EXACT, ReflectionMode.STALE, storage, threads, ViewEffects.ALL.withForced(forced))
                        .withEngines(new MixedEngineChoice(engines));
        try (Renderer renderer = new Renderer(options)) {
            Scene before = session.scenes().getFirst();
            Scene mirrored = before;
            for (int step : session.steps()) {
                Scene scene = session.scenes().get(step);
                UpdateResult update = renderer.render(scene, Progress.NONE);
                // Forced effects may change how normals are bent.
                mirrored = refreshesReflections(options.view().apply(before), options.view().apply(scene)) ? scene : mirrored;
                SessionAssert.assertSameBits(renderer.film(), new ReferenceTracer(scene, mirrored).trace(),
                        "stale-reflections", session, step, update.plan().description());
                assertStatementHolds(AccuracyGuarantee.of(renderer, update), renderer, session, step);
                if (step % refreshEach == refreshEach - 1) {
                    UpdateResult updated = renderer.updateReflections(Progress.NONE);
                    mirrored = scene;
                    SessionAssert.assertSameBits(renderer.film(), new ReferenceTracer(scene).trace(),
                            "updated-reflections", session, step, "reflections");
                    assertThat(AccuracyGuarantee.of(renderer, updated).text()).isEqualTo("exact");
                }
                assertThat(renderer.cache().hasCurrentReflections())
                        .isEqualTo(options.view().apply(mirrored).hasSameImage(options.view().apply(scene)));
                before = scene;
            }
        }
    }

    /** Checks the accuracy statement: an exact picture has the bits of a full trace, and without bounced rays it is never stale. */
    private static void assertStatementHolds(AccuracyGuarantee promise, Renderer renderer, EditSession session, int step) {
        Scene scene = session.scenes().get(step);
        boolean bounces = scene.picture().depth() > 0 && scene.placedShapes().stream().map(PlacedShape::material)
                .anyMatch(Material::spawnsSecondaryRays);
        assertThat(bounces || !promise.isStale()).as(session.toString()).isTrue();
        assertThat(promise.text()).isEqualTo(promise.isStale() ? "exact, reflections out of date" : "exact");
        Statistics.label("statement").collect(promise.isStale() ? "stale" : "exact");
        if (!promise.isStale()) {
            SessionAssert.assertSameBits(renderer.film(), new ReferenceTracer(scene).trace(), "called-exact", session, step,
                    promise.text());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {TransparentScenes.BALL, TransparentScenes.PANE})
    void lightVisibleOnlyThroughClearShapes_isReportedStale(String text) {
        Scene scene = TransparentScenes.scene(text);
        Scene dim = scene.withLight(scene.lights().getFirst().withIntensity(0.3));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withReflections(ReflectionMode.STALE).withThreads(1))) {
            renderer.render(scene, Progress.NONE);
            AccuracyGuarantee edited = AccuracyGuarantee.of(renderer, renderer.render(dim, Progress.NONE));
            assertThat(renderer.film().hasSameBits(new ReferenceTracer(dim).trace())).as("glass shows the older light").isFalse();
            assertThat(edited.text()).isEqualTo("exact, reflections out of date");
            AccuracyGuarantee updated = AccuracyGuarantee.of(renderer, renderer.updateReflections(Progress.NONE));
            assertThat(renderer.film().hasSameBits(new ReferenceTracer(dim).trace())).isTrue();
            assertThat(updated.text()).isEqualTo("exact");
        }
    }

    /**
     * Returns whether an edit refreshes mirror images: edits of depth, sampling, size and hit geometry, and of the normals and shadow rays
     * there.
     */
    static boolean refreshesReflections(Scene before, Scene scene) {
        return !before.picture().withIndirect(Optional.empty()).equals(scene.picture().withIndirect(Optional.empty()))
                || !before.camera().hasSameView(scene.camera()) || !before.hasSameSamples(scene)
                || !before.stage().rendered().nodes().equals(scene.stage().rendered().nodes()) || !haveSameShadowRayTargets(before, scene);
    }

    /** Compares scenes with the same shapes. */
    private static boolean haveSameShadowRayTargets(Scene before, Scene scene) {
        Stage stage = scene.stage().rendered();
        return stage.usedMaterials().stream().allMatch(name -> before.stage().rendered().materialsByName().get(name)
                .hasSameRays(stage.materialsByName().get(name)));
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void unchangedScene_costsNothing(@ForAll("sessions") EditSession session, @ForAll ReflectionMode reflections) {
        try (Renderer renderer = new Renderer(new RenderOptions(Accuracy.EXACT, reflections, MirrorStorage.FULL_ROWS, 1))) {
            Scene rendered = session.scenes().getFirst();
            renderer.render(rendered, Progress.NONE);
            Film film = renderer.film().copy();
            for (Scene edited : session.timedScenes()) {
                renderer.plan(edited);
            }
            UpdateResult update = renderer.render(copy(rendered), Progress.NONE);
            assertThat(update.plan()).isEqualTo(new UpdatePlan.Nothing());
            assertThat(update.rays()).isEqualTo(RayCounts.NONE);
            assertThat(update.rowsTouched() + update.rowsComposed()).isZero();
            assertThat(renderer.film().hasSameBits(film)).isTrue();
        }
    }

    /** Returns an equal scene that shares no list with the given one. */
    private static Scene copy(Scene s) {
        return new Scene(s.picture().withDepth(s.picture().depth()), s.camera(), s.world(),
                new Stage(List.copyOf(s.materials().reversed()).reversed(), List.copyOf(s.nodes().reversed()).reversed()),
                LightRig.of(s.lights().stream().map(l -> l.withName(l.name())).toList(),
                        List.copyOf(s.rig().lightGroups().reversed()).reversed()));
    }
}
