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
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.MirrorStorage;
import lightning.render.relight.tile.Options;
import lightning.render.shading.SceneCoverage;
import lightning.sample.Session;
import lightning.sample.Slow;
import lightning.scene.Scene;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.statistics.StatisticsReport;

/** An update that is cancelled or fails leaves everything as if it had never begun. */
@Slow
class CancellationTest {
    /** So many stops that even an underflow would show: at accuracy ratio every scaling is followed by a refresh. */
    private static final double REFRESHING = 160;

    @Provide
    Arbitrary<Session> sessions() {
        return Session.sessions();
    }

    /** How an update ends before it is done. */
    enum End {
        CANCELLED {
            @Override
            Progress after(int questions) {
                return new CancelAfter(questions);
            }
        },
        OUT_OF_MEMORY {
            @Override
            Progress after(int questions) {
                return new FailAfter(questions, OutOfMemoryError::new);
            }
        };

        abstract Progress after(int questions);
    }

    /** Two renderers go through a session; the updates of one are ended once before they are done. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    @StatisticsReport(onFailureOnly = true)
    void endedUpdates_leaveFilmPlanAndAllLaterWorkUnchanged(@ForAll("sessions") Session session, @ForAll End end,
            @ForAll @IntRange(min = 0, max = 12) int questions, @ForAll MirrorStorage storage, @ForAll Reflections reflections,
            @ForAll @IntRange(min = 1, max = 3) int threads, @ForAll Accuracy accuracy, @ForAll boolean refreshing) {
        Options options = new Options(accuracy, reflections, storage, threads);
        try (Renderer undisturbed = new Renderer(options); Renderer disturbed = new Renderer(options)) {
            undisturbed.setView(refreshing ? REFRESHING : 0, DisplayCurve.SRGB);
            disturbed.setView(refreshing ? REFRESHING : 0, DisplayCurve.SRGB);
            Scene first = session.scenes().getFirst();
            undisturbed.render(first, Progress.NONE);
            disturbed.render(first, Progress.NONE);
            int cancelled = 0;
            for (int step = 1; step < session.scenes().size(); step++) {
                Scene scene = session.scenes().get(step);
                Update actual = interrupted(disturbed, scene, end.after(questions + step % 3), session, step);
                cancelled += actual == null ? 1 : 0;
                actual = actual == null ? disturbed.render(scene, Progress.NONE) : actual;
                assertThat(work(actual)).isEqualTo(work(undisturbed.render(scene, Progress.NONE)));
                SessionAssert.assertSameBits(disturbed.film(), undisturbed.film(), "after-a-cancelled-update", session, step,
                        actual.plan().text());
            }
            SceneCoverage.collect("cancelled", cancelled > 0, 35);
        }
    }

    /** An update that may be ended on its way; null if it was, and then nothing may be different. */
    private static Update interrupted(Renderer renderer, Scene wanted, Progress ending, Session session, int step) {
        Film film = renderer.film().copy();
        Scene scene = renderer.scene();
        UpdatePlan plan = renderer.plan(wanted).update();
        try {
            return renderer.render(wanted, ending);
        } catch (CancellationException | OutOfMemoryError e) {
            assertThat(renderer.scene()).isSameAs(scene);
            assertThat(parts(renderer.plan(wanted).update())).isEqualTo(parts(plan));
            SessionAssert.assertSameBits(renderer.film(), film, "cancelled-update", session, step, plan.text());
            return null;
        }
    }

    /** What an update says but for its time. */
    private static List<Object> work(Update update) {
        return List.of(parts(update.plan()), update.rowsTouched(), update.rowsComposed(), update.rays());
    }

    /** All of a plan, but of a change of shapes only that there is one: each is found anew and equal to none but itself. */
    private static Object parts(UpdatePlan plan) {
        return plan instanceof UpdatePlan.Relight r
                ? Arrays.asList(parts(r.top()), parts(r.mirrors()), r.depthFrom(), r.depthTo(), r.resampled(), r.shapes().isEmpty()) : plan;
    }

    private static Object parts(LevelPlan level) {
        return level == null ? "none" : List.of(level.layers().stream().map(CancellationTest::parts).toList(), level.dropped(),
                level.compose(), level.materials());
    }

    private static Object parts(LayerPlan layer) {
        return Arrays.asList(layer.light(), layer.from(), layer.update(), layer.shadows().isEmpty());
    }
}
