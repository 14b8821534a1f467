package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.RayCounts;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.EditSession;
import lightning.sample.Slow;
import lightning.sample.StudioScene;
import lightning.scene.GatherSettings;
import lightning.scene.Scene;
import lightning.scene.light.LightType;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;

/** Tests that a change of accuracy during a session keeps the cache and stays within its guarantees. */
class CacheConversionTest {
    private static final RenderOptions EXACT = new RenderOptions(Accuracy.EXACT, ReflectionMode.STALE, MirrorStorage.FULL_ROWS, 1);
    private static final RenderOptions RATIO = EXACT.withAccuracy(Accuracy.RATIO);

    @Provide
    Arbitrary<EditSession> sessions() {
        return EditSession.sessions();
    }

    /** Returns sessions without gathered light, whose pictures are not converted. */
    @Provide
    Arbitrary<EditSession> directSessions() {
        return EditSession.sessions().filter(session -> session.scenes().stream().allMatch(scene -> GatherSettings.of(scene).isEmpty()));
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    @Slow
    void accuracySwitch_keepsGuaranteeOfEachAccuracy(@ForAll("sessions") EditSession session,
            @ForAll @Size(13) List<Accuracy> accuracies, @ForAll ReflectionMode reflections,
            @ForAll @IntRange(min = 1, max = 2) int threads) {
        RenderOptions options = EXACT.withReflections(reflections).withThreads(threads);
        try (Renderer renderer = new Renderer(options.withAccuracy(accuracies.getLast()))) {
            for (int step : session.steps()) {
                renderer.setOptions(options.withAccuracy(accuracies.get(step)));
                UpdateResult update = renderer.render(session.scenes().get(step), Progress.NONE);
                if (accuracies.get(step) == Accuracy.EXACT) {
                    assertThat(update.errorBound()).isZero();
                }
                ReferenceCheck.assertGuarantee(renderer, update, "after edit " + step);
            }
        }
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void accuracySwitch_castsNoRays(@ForAll("directSessions") EditSession session, @ForAll boolean toRatio) {
        try (Renderer renderer = new Renderer(toRatio ? EXACT : RATIO)) {
            for (Scene scene : session.timedScenes()) {
                renderer.render(scene, Progress.NONE);
            }
            Scene last = renderer.scene();
            renderer.setOptions(toRatio ? RATIO : EXACT);
            UpdateResult update = renderer.render(last, Progress.NONE);
            assertThat(update.rays()).isEqualTo(RayCounts.NONE);
            Film expected = new ReferenceTracer(last, renderer.cache().mirrored().scene()).trace();
            if (toRatio) {
                assertThat(FilmError.largestError(renderer.film(), expected)).as(session.toString())
                        .isLessThanOrEqualTo(update.errorBound());
            } else {
                SessionAssert.assertSameBits(renderer.film(), expected, "switch", session, session.scenes().lastIndexOf(last),
                        update.plan().description());
            }
        }
    }

    /** The deletion of a shape removes its gain, too, so rows no longer store their shapes. */
    @Test
    void gainOnDeletedShape_endsWithIt() throws Exception {
        Scene scene = JenReader.read("""
                jen 1
                picture { size 33 15  depth 2 }
                camera { from -0.6 1 7 to 0 0 0 }
                material mirror { reflective 0.5 0.5 0.5 }
                plane floor { at 0 -1 0  scale 14 1 14 }
                sphere ball { material mirror at -2 0 0 }
                light lamp point { at 0 3 2 gains "ball" 0.3 }
                """, "gain.jen", Path.of("")).scene();
        for (boolean toRatio : new boolean[] {true, false}) {
            try (Renderer renderer = new Renderer(toRatio ? EXACT : RATIO)) {
                renderer.render(scene, Progress.NONE);
                Scene without = scene.withNodes(scene.nodes().subList(0, 1));
                renderer.render(without, Progress.NONE);
                renderer.setOptions(toRatio ? RATIO : EXACT);
                double bound = renderer.render(without, Progress.NONE).errorBound();
                assertThat(FilmError.largestError(renderer.film(), new ReferenceTracer(without).trace())).isLessThanOrEqualTo(bound);
            }
        }
    }

    @Test
    void switchToRatio_equalsFirstPass() {
        Scene scene = StudioScene.of(LightType.SPOT);
        try (Renderer switched = new Renderer(EXACT); Renderer first = new Renderer(RATIO)) {
            switched.render(scene, Progress.NONE);
            switched.setOptions(RATIO);
            UpdateResult update = switched.render(scene, Progress.NONE);
            first.render(scene, Progress.NONE);
            assertThat(update.plan().description()).isEqualTo("key: refresh, reflections");
            assertThat(switched.cache().bytes()).isEqualTo(first.cache().bytes());
            assertThat(switched.film().hasSameBits(first.film())).isTrue();
        }
    }

    @Test
    void reflectionsSwitchedToCurrent_updateOnlyMirrors() {
        Scene scene = StudioScene.of(LightType.SPOT);
        Scene edited = scene.withWorld(scene.world().withAmbience(0.5));
        try (Renderer renderer = new Renderer(EXACT)) {
            renderer.render(scene, Progress.NONE);
            renderer.render(edited, Progress.NONE);
            renderer.setOptions(EXACT.withReflections(ReflectionMode.CURRENT));
            UpdateResult update = renderer.render(edited, Progress.NONE);
            assertThat(update.plan().description()).isEqualTo("reflections");
            assertThat(update.rays()).isEqualTo(RayCounts.NONE);
        }
    }

    @Test
    void mirrorsStoredAsHitShapes_areRetraced() {
        Scene scene = StudioScene.of(LightType.SPOT);
        Scene mirroring = scene.withPicture(scene.picture().withDepth(2));
        RenderOptions shapes = EXACT.withStorage(MirrorStorage.HIT_SHAPES);
        try (Renderer renderer = new Renderer(shapes)) {
            renderer.render(mirroring, Progress.NONE);
            renderer.setOptions(shapes.withAccuracy(Accuracy.RATIO));
            assertThat(renderer.plan(mirroring).update()).isInstanceOf(UpdatePlan.FirstPass.class);
        }
    }

    @Test
    void canceledSwitch_leavesOldImage() {
        Scene scene = StudioScene.of(LightType.SPOT);
        try (Renderer renderer = new Renderer(RATIO)) {
            renderer.render(scene, Progress.NONE);
            Film before = renderer.film();
            renderer.setOptions(EXACT);
            assertThatThrownBy(() -> renderer.render(scene, new CancelingProgress(0))).isInstanceOf(CancellationException.class);
            assertThat(renderer.film().hasSameBits(before)).isTrue();
            assertThat(renderer.render(scene, Progress.NONE).rays()).isEqualTo(RayCounts.NONE);
        }
    }
}
