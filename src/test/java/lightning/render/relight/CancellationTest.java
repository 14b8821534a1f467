package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Film;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.LayerPlan;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.UpdatePlan;
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

/** Tests that a canceled or failed update leaves the state as before. */
@Slow
class CancellationTest {
    /** Exposure in stops at which even an underflow would be visible: at accuracy ratio a refresh follows every scaling. */
    private static final double REFRESH_EXPOSURE = 160;

    @Provide
    Arbitrary<EditSession> sessions() {
        return EditSession.mixedSessions();
    }

    /** Kinds of interruption of an update. */
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

    /** Two renderers run a session; each update of one of them is interrupted once before it completes. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    @StatisticsReport(onFailureOnly = true)
    void interruptedUpdates_leaveStateUnchanged(@ForAll("sessions") EditSession session, @ForAll Interruption end,
            @ForAll @IntRange(min = 0, max = 12) int checks, @ForAll MirrorStorage storage, @ForAll ReflectionMode reflections,
            @ForAll @IntRange(min = 1, max = 3) int threads, @ForAll Accuracy accuracy, @ForAll boolean refreshing) {
        RenderOptions options = new RenderOptions(accuracy, reflections, storage, threads);
        try (Renderer uninterrupted = new Renderer(options); Renderer disrupted = new Renderer(options)) {
            uninterrupted.setView(refreshing ? REFRESH_EXPOSURE : 0, DisplayCurve.SRGB);
            disrupted.setView(refreshing ? REFRESH_EXPOSURE : 0, DisplayCurve.SRGB);
            Scene first = session.scenes().getFirst();
            uninterrupted.render(first, Progress.NONE);
            disrupted.render(first, Progress.NONE);
            int cancelled = 0;
            for (int step = 1; step < session.scenes().size(); step++) {
                Scene scene = session.scenes().get(step);
                UpdateResult actual = interrupted(disrupted, scene, end.after(checks + step % 3), session, step);
                cancelled += actual == null ? 1 : 0;
                actual = actual == null ? disrupted.render(scene, Progress.NONE) : actual;
                assertThat(work(actual)).isEqualTo(work(uninterrupted.render(scene, Progress.NONE)));
                SessionAssert.assertSameBits(disrupted.film(), uninterrupted.film(), "after-a-canceled-update", session, step,
                        actual.plan().description());
            }
            SceneCoverage.collect("canceled", cancelled > 0, 35);
        }
    }

    /** Runs an update that may be interrupted; returns null if it was, after checking that nothing changed. */
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

    /** Returns the contents of an update result except for its time. */
    private static List<Object> work(UpdateResult update) {
        return List.of(parts(update.plan()), update.rowsTouched(), update.rowsComposed(), update.rays());
    }

    /** Returns the parts of a plan, but only the existence of a shape change, because each instance equals only itself. */
    private static Object parts(UpdatePlan plan) {
        return plan instanceof UpdatePlan.Relight r
                ? Arrays.asList(parts(r.top()), parts(r.mirrors()), r.oldDepth(), r.newDepth(), r.resampled(), r.shapes().isEmpty()) : plan;
    }

    private static Object parts(LevelPlan level) {
        return level == null ? "none" : List.of(level.layers().stream().map(CancellationTest::parts).toList(), level.droppedLights(),
                level.materials());
    }

    private static Object parts(LayerPlan layer) {
        return Arrays.asList(layer.light(), layer.base(), layer.update(), layer.shadows().isEmpty());
    }
}
