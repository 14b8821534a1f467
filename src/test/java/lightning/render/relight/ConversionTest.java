package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.render.image.Film;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.MirrorStorage;
import lightning.render.relight.tile.Options;
import lightning.render.shading.ReferenceTracer;
import lightning.render.shading.TraceCounts;
import lightning.sample.Session;
import lightning.sample.Slow;
import lightning.sample.StudioScene;
import lightning.scene.LightType;
import lightning.scene.Scene;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;

/** Another accuracy, in the midst of a session, keeps what is known and breaks no promise. */
class ConversionTest {
    private static final Options EXACT = new Options(Accuracy.EXACT, Reflections.STALE, MirrorStorage.FULL_ROWS, 1);
    private static final Options RATIO = EXACT.withAccuracy(Accuracy.RATIO);

    @Provide
    Arbitrary<Session> sessions() {
        return Session.sessions();
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    @Slow
    void switchedAnywhere_eachPictureKeepsItsLevelsPromise(@ForAll("sessions") Session session,
            @ForAll @Size(13) List<Accuracy> accuracies, @ForAll Reflections reflections, @ForAll @IntRange(min = 1, max = 2) int threads) {
        Options options = EXACT.withReflections(reflections).withThreads(threads);
        try (Renderer renderer = new Renderer(options.withAccuracy(accuracies.getLast()))) {
            for (int step = 0; step < session.scenes().size(); step++) {
                renderer.change(options.withAccuracy(accuracies.get(step)));
                Update update = renderer.render(session.scenes().get(step), Progress.NONE);
                if (accuracies.get(step) == Accuracy.EXACT) {
                    assertThat(update.errorBound()).isZero();
                }
                Oracle.assertKept(renderer, update, "after edit " + step);
            }
        }
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void switch_castsNoRay(@ForAll("sessions") Session session, @ForAll boolean toRatio) {
        Scene last = session.scenes().getLast();
        try (Renderer renderer = new Renderer(toRatio ? EXACT : RATIO)) {
            for (Scene scene : session.scenes()) {
                renderer.render(scene, Progress.NONE);
            }
            renderer.change(toRatio ? RATIO : EXACT);
            Update update = renderer.render(last, Progress.NONE);
            assertThat(update.rays()).isEqualTo(TraceCounts.NONE);
            SessionAssert.assertSameBits(renderer.film(), new ReferenceTracer(last, renderer.cache().mirroredScene()).trace(),
                    "switch", session, session.scenes().size() - 1, update.plan().text());
        }
    }

    @Test
    void switchToRatio_storesWhatAFirstPassWould() {
        Scene scene = StudioScene.of(LightType.SPOT);
        try (Renderer switched = new Renderer(EXACT); Renderer first = new Renderer(RATIO)) {
            switched.render(scene, Progress.NONE);
            switched.change(RATIO);
            Update update = switched.render(scene, Progress.NONE);
            first.render(scene, Progress.NONE);
            assertThat(update.plan().text()).isEqualTo("key: refresh, reflections");
            assertThat(switched.cache().bytes()).isEqualTo(first.cache().bytes());
            assertThat(switched.film().sameBits(first.film())).isTrue();
        }
    }

    @Test
    void reflectionsSwitchedToCurrent_areUpdatedAndNothingElse() {
        Scene scene = StudioScene.of(LightType.SPOT);
        Scene edited = scene.withWorld(scene.world().withAmbience(0.5));
        try (Renderer renderer = new Renderer(EXACT)) {
            renderer.render(scene, Progress.NONE);
            renderer.render(edited, Progress.NONE);
            renderer.change(EXACT.withReflections(Reflections.CURRENT));
            Update update = renderer.render(edited, Progress.NONE);
            assertThat(update.plan().text()).isEqualTo("reflections");
            assertThat(update.rays()).isEqualTo(TraceCounts.NONE);
        }
    }

    @Test
    void mirrorsKeptAsHitShapes_areTracedAnew() {
        Scene scene = StudioScene.of(LightType.SPOT);
        Scene mirroring = scene.withPicture(scene.picture().withDepth(2));
        Options shapes = EXACT.withStorage(MirrorStorage.HIT_SHAPES);
        try (Renderer renderer = new Renderer(shapes)) {
            renderer.render(mirroring, Progress.NONE);
            renderer.change(shapes.withAccuracy(Accuracy.RATIO));
            assertThat(renderer.plan(mirroring).update()).isInstanceOf(UpdatePlan.FirstPass.class);
        }
    }

    @Test
    void cancelledSwitch_leavesThePictureOfTheOldLevel() {
        Scene scene = StudioScene.of(LightType.SPOT);
        try (Renderer renderer = new Renderer(RATIO)) {
            renderer.render(scene, Progress.NONE);
            Film before = renderer.film();
            renderer.change(EXACT);
            assertThatThrownBy(() -> renderer.render(scene, new CancelAfter(0))).isInstanceOf(CancellationException.class);
            assertThat(renderer.film().sameBits(before)).isTrue();
            assertThat(renderer.render(scene, Progress.NONE).rays()).isEqualTo(TraceCounts.NONE);
        }
    }
}
