package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Film;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.LayerPlan;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.ReflectionMode;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.MirrorStorage;
import lightning.render.relight.tile.RenderOptions;
import lightning.render.shading.SceneCoverage;
import lightning.sample.EditSession;
import lightning.sample.Slow;
import lightning.scene.Scene;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.statistics.StatisticsReport;

/** An update that is canceled or fails leaves everything as if it had never begun. */
@Slow
class CancellationTest {
    /** So many stops that even an underflow would show: at accuracy ratio every scaling is followed by a refresh. */
    private static final double REFRESHING = 160;

    @Provide
    Arbitrary<EditSession> sessions() {
        return EditSession.sessions();
    }

    /** How an update ends before it is done. */
    enum Interruption {
        CANCELLED {
            @Override
            Progress after(int questions) {
                return new CancelingProgress(questions);
            }
        },
        OUT_OF_MEMORY {
            @Override
            Progress after(int questions) {
                return new FailingProgress(questions, OutOfMemoryError::new);
            }
        };

        abstract Progress after(int checks);
    }

    /** Two renderers go through a session; the updates of one are ended once before they are done. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    @StatisticsReport(onFailureOnly = true)
    void interruptedUpdates_leaveStateUnchanged(@ForAll("sessions") EditSession session, @ForAll Interruption end,
            @ForAll @IntRange(min = 0, max = 12) int checks, @ForAll MirrorStorage storage, @ForAll ReflectionMode reflections,
            @ForAll @IntRange(min = 1, max = 3) int threads, @ForAll Accuracy accuracy, @ForAll boolean refreshing) {
        RenderOptions options = new RenderOptions(accuracy, reflections, storage, threads);
        try (Renderer undisturbed = new Renderer(options); Renderer disturbed = new Renderer(options)) {
            undisturbed.setView(refreshing ? REFRESHING : 0, DisplayCurve.SRGB);
            disturbed.setView(refreshing ? REFRESHING : 0, DisplayCurve.SRGB);
            Scene first = session.scenes().getFirst();
            undisturbed.render(first, Progress.NONE);
            disturbed.render(first, Progress.NONE);
            int cancelled = 0;
            for (int step = 1; step < session.scenes().size(); step++) {
                Scene scene = session.scenes().get(step);
                UpdateResult actual = interrupted(disturbed, scene, end.after(checks + step % 3), session, step);
                cancelled += actual == null ? 1 : 0;
                actual = actual == null ? disturbed.render(scene, Progress.NONE) : actual;
                assertThat(work(actual)).isEqualTo(work(undisturbed.render(scene, Progress.NONE)));
                SessionAssert.assertSameBits(disturbed.film(), undisturbed.film(), "after-a-canceled-update", session, step,
                        actual.plan().description());
            }
            SceneCoverage.collect("canceled", cancelled > 0, 35);
        }
    }

    /** An update that may be ended on its way; null if it was, and then nothing may be different. */
    private static UpdateResult interrupted(Renderer renderer, Scene target, Progress ending, EditSession session, int step) {
        Film film = renderer.film().copy();
        Scene scene = renderer.scene();
        UpdatePlan plan = renderer.plan(target).update();
        try {
            return renderer.render(target, ending);
        } catch (CancellationException | OutOfMemoryError e) {
            assertThat(renderer.scene()).isSameAs(scene);
            assertThat(parts(renderer.plan(target).update())).isEqualTo(parts(plan));
            SessionAssert.assertSameBits(renderer.film(), film, "canceled-update", session, step, plan.description());
            return null;
        }
    }

    /** What an update says but for its time. */
    private static List<Object> work(UpdateResult update) {
        return List.of(parts(update.plan()), update.rowsTouched(), update.rowsComposed(), update.rays());
    }

    /** All of a plan, but of a change of shapes only that there is one: each is found anew and equal to none but itself. */
    private static Object parts(UpdatePlan plan) {
        return plan instanceof UpdatePlan.Relight r
                ? Arrays.asList(parts(r.top()), parts(r.mirrors()), r.oldDepth(), r.newDepth(), r.resampled(), r.shapes().isEmpty()) : plan;
    }

    private static Object parts(LevelPlan level) {
        return level == null ? "none" : List.of(level.layers().stream().map(CancellationTest::parts).toList(), level.droppedLights(),
                level.recomposeAll(), level.materials());
    }

    private static Object parts(LayerPlan layer) {
        return Arrays.asList(layer.light(), layer.base(), layer.update(), layer.shadows().isEmpty());
    }
}
