package lightning.document.loop;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.PathUpdate;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.render.trace.Geometry;
import lightning.sample.IndirectScenes;
import lightning.sample.Slow;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import lightning.scene.node.Shape;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The picture with direct light that precedes the one with indirect light. */
class DirectLightFirstTest {
    /** Paths count as slow even if they take no time at all, so that these tests do not depend on the speed of the machine. */
    private static final double ALWAYS_SLOW = -1;

    private final RecordingRenderListener listener = new RecordingRenderListener();
    private final RenderLoop loop =
            new RenderLoop(RenderOptions.DEFAULT.withReflections(ReflectionMode.STALE).withThreads(2), listener, ALWAYS_SLOW);
    private final Scene scene = IndirectScenes.all().get("mirror ball");

    @AfterEach
    void close() {
        loop.close();
    }

    private RecordingRenderListener.Shown next() throws InterruptedException {
        return listener.next(RecordingRenderListener.Shown.class);
    }

    private static void assertShows(RecordingRenderListener.Shown shown, Scene expected) {
        assertThat(shown.frame().scene()).isEqualTo(expected);
        assertThat(shown.film().hasSameBits(new ReferenceTracer(expected).trace())).isTrue();
    }

    private Scene dimmed(double intensity) {
        return scene.withLight(scene.lights().getFirst().withIntensity(intensity));
    }

    @Test
    void firstPass_showsDirectLightThenAddsIndirectLight() throws InterruptedException {
        loop.render(scene);
        RecordingRenderListener.Shown direct = next();
        assertShows(direct, scene.withoutIndirect());
        assertThat(direct.frame().step()).isEqualTo(Frame.Step.DIRECT_LIGHT);
        assertThat(direct.frame().showsDirectLightOf(scene)).isTrue();
        RecordingRenderListener.Shown shown = next();
        assertShows(shown, scene);
        assertThat(shown.frame().mirrorsAreCurrent()).isTrue();
        assertThat(shown.frame().step()).isEqualTo(Frame.Step.INDIRECT_LIGHT);
        assertThat(shown.frame().showsDirectLightOf(scene)).isFalse();
        listener.expectNext(RecordingRenderListener.Event.IDLE);
    }

    /** The light of an environment is gathered along the same paths, so direct light alone would take as long. */
    @Test
    void environment_isShownWithAllLightAtOnce() throws InterruptedException {
        Scene lit = IndirectScenes.all().get("environment with a sun");
        loop.render(lit);
        RecordingRenderListener.Shown shown = next();
        assertShows(shown, lit);
        assertThat(shown.frame().step()).isEqualTo(Frame.Step.ALL_LIGHT);
        listener.expectNext(RecordingRenderListener.Event.IDLE);
    }

    @Test
    void lightEdit_isOneStep() throws InterruptedException {
        loop.render(scene);
        listener.expectNext(RecordingRenderListener.Event.IDLE);
        loop.render(dimmed(0.5));
        Frame edited = next().frame();
        assertThat(edited.scene()).isEqualTo(dimmed(0.5));
        assertThat(edited.step()).isEqualTo(Frame.Step.ALL_LIGHT);
    }

    @Test
    void settings_keepThePictureUntilTheNextIsFinished() throws InterruptedException {
        loop.render(scene);
        listener.expectNext(RecordingRenderListener.Event.IDLE);
        Scene denser = scene.withPicture(scene.picture().withIndirect(scene.picture().indirect().map(i -> i.withSpacing(2))));
        loop.render(denser);
        assertShows(next(), denser);
    }

    @Test
    void camera_showsDirectLightFirst() throws InterruptedException {
        loop.render(scene);
        listener.expectNext(RecordingRenderListener.Event.IDLE);
        Scene moved = scene.withCamera(scene.camera().withOrigin(new Vec3(0.2, 0, 4)));
        loop.render(moved);
        assertShows(next(), moved.withoutIndirect());
        assertShows(next(), moved);
    }

    /** Paths take longer than the shortest wait that an artist notices. */
    private Scene slowScene() {
        Scene slow = IndirectScenes.all().get("mirror ball");
        return slow.withPicture(slow.picture().withSize(192, 128).withIndirect(Optional.of(new IndirectSettings(2, 256, 2, false))));
    }

    private static Scene moved(Scene scene, double x) {
        return scene.withNodes(scene.nodes().stream().map(node -> node instanceof Shape ball && ball.name().equals("ball")
                ? ball.withPlacement(ball.placement().withPosition(new Vec3(x, -0.5, -0.2))) : node).toList());
    }

    private static void assertExact(RecordingRenderListener.Shown shown, Scene expected) {
        assertThat(shown.frame().scene()).isEqualTo(expected);
        assertThat(shown.frame().mirrorsAreCurrent()).isTrue();
        try (WorkerPool workers = new WorkerPool(2)) {
            assertThat(
                    shown.film().hasSameBits(new TraditionalTracer(expected, Geometry.of(expected)).trace(workers, Progress.NONE).film()))
                    .isTrue();
        }
    }

    @Test
    @Slow
    void movedObject_showsDirectLightFirstAndKeepsPaths() throws InterruptedException {
        Scene slow = slowScene();
        loop.render(slow);
        listener.expectNext(RecordingRenderListener.Event.IDLE);
        Scene moved = moved(slow, 0.3);
        loop.render(moved);
        assertExact(next(), moved.withoutIndirect());
        RecordingRenderListener.Shown whole = next();
        assertExact(whole, moved);
        assertThat(((UpdatePlan.Relight) whole.frame().update().plan()).paths()).isEqualTo(PathUpdate.REPEAT);
    }

    @Test
    @Slow
    void draggedObject_showsEachPlaceWithDirectLightAndKeepsPathsAtTheEnd() throws InterruptedException {
        Scene slow = slowScene();
        loop.render(slow);
        listener.expectNext(RecordingRenderListener.Event.IDLE);
        var hold = listener.holdAfterNextPicture();
        Scene first = moved(slow, 0.3);
        loop.render(first);
        hold.awaitReached();
        Scene second = moved(slow, 0.4);
        loop.render(second);
        hold.release();
        assertExact(next(), first.withoutIndirect());
        assertExact(next(), second.withoutIndirect());
        RecordingRenderListener.Shown whole = next();
        assertExact(whole, second);
        assertThat(((UpdatePlan.Relight) whole.frame().update().plan()).paths()).isEqualTo(PathUpdate.REPEAT);
    }

    @Test
    @Slow
    void cameraMovedWhilePathsAreKept_isExact() throws InterruptedException {
        Scene slow = slowScene();
        loop.render(slow);
        listener.expectNext(RecordingRenderListener.Event.IDLE);
        var hold = listener.holdAfterNextPicture();
        Scene first = moved(slow, 0.3);
        loop.render(first);
        hold.awaitReached();
        Scene other = first.withCamera(first.camera().withOrigin(new Vec3(0.2, 0, 4)));
        loop.render(other);
        hold.release();
        assertExact(next(), first.withoutIndirect());
        assertExact(next(), other.withoutIndirect());
        assertExact(next(), other);
    }

    @Test
    void cancel_leavesDirectLight() throws InterruptedException {
        var hold = listener.holdAfterNextPicture();
        loop.render(scene);
        hold.awaitReached();
        loop.cancel();
        hold.release();
        RecordingRenderListener.Shown direct = next();
        assertShows(direct, scene.withoutIndirect());
        assertThat(direct.frame().step()).isEqualTo(Frame.Step.DIRECT_LIGHT);
        listener.expectNext(RecordingRenderListener.Event.CANCELLED);
        listener.expectNext(RecordingRenderListener.Event.IDLE);
        loop.render(scene);
        assertThat(listener.next(RecordingRenderListener.Started.class).plan()).isInstanceOf(UpdatePlan.Relight.class);
        assertShows(next(), scene);
    }

    @Test
    void editMeanwhile_isShownWithDirectLightAndReplacesTheOldOne() throws InterruptedException {
        var hold = listener.holdAfterNextPicture();
        loop.render(scene);
        hold.awaitReached();
        loop.render(dimmed(0.5));
        hold.release();
        assertShows(next(), scene.withoutIndirect());
        assertThat(next().frame().scene()).isEqualTo(dimmed(0.5).withoutIndirect());
        assertThat(next().frame().scene()).isEqualTo(dimmed(0.5));
    }

    @Test
    void progress_growsToTheEnd() throws InterruptedException {
        List<Double> shares = Collections.synchronizedList(new ArrayList<>());
        var counting = new RenderListener() {
            private volatile boolean isIndirect;

            @Override
            public void indirectStarted() {
                isIndirect = true;
            }

            @Override
            public void progress(int done, int total) {
                if (isIndirect) {
                    shares.add((double) done / total);
                }
            }

            @Override
            public void idle() {
                listener.idle();
            }
        };
        try (var single = new RenderLoop(RenderOptions.DEFAULT.withThreads(1), counting)) {
            single.render(scene);
            listener.expectNext(RecordingRenderListener.Event.IDLE);
        }
        assertThat(shares).isSorted().hasSizeGreaterThan(5).endsWith(1.0);
        assertThat(shares.getFirst()).isLessThan(0.2);
    }
}
