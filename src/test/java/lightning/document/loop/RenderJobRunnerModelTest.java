package lightning.document.loop;

import static lightning.modelcheck.ScheduleExplorer.check;
import static lightning.modelcheck.ScheduleExplorer.explore;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Executor;
import lightning.document.DeskScene;
import lightning.modelcheck.ScheduleExplorer;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Model test of the path from an edit on the window's thread over the loop's thread to the finished image. */
@Tag("model")
class RenderJobRunnerModelTest {
    private static final Scene FIRST = DeskScene.scene();
    private static final Scene SECOND = DeskScene.sceneOf(DeskScene.parameter("intensity").set(FIRST, "key", 2));
    private static final Scene LARGER = FIRST.withPicture(FIRST.picture().withSize(80, 60));

    private static final Scene SAMPLED = FIRST.withPicture(FIRST.picture().withSampling(new SamplingSettings(AntialiasMode.EDGES, 2)));
    private static final Scene SECOND_SAMPLED = SECOND.withPicture(SAMPLED.picture());

    /** Model of the window's thread: runs its tasks in order when it has time. */
    private static final class Window implements Executor {
        private final ArrayDeque<Runnable> tasks = new ArrayDeque<>();

        @Override
        public synchronized void execute(Runnable task) {
            tasks.add(task);
            notifyAll();
        }

        private synchronized Runnable next() throws InterruptedException {
            while (tasks.isEmpty()) {
                wait();
            }
            return tasks.remove();
        }

        synchronized boolean isEmpty() {
            return tasks.isEmpty();
        }

        void runOne() throws InterruptedException {
            next().run();
        }
    }

    /** Model of a renderer with two tiles, and two more for anti-aliasing samples. */
    private static final class TileJobHandler implements RenderJobRunner.RenderJobHandler {
        private final RenderListener listener;
        private final RenderQueue queue;
        private final Scene broken;
        private Scene renderedScene;
        private boolean isFinished = true;
        private boolean closed;

        TileJobHandler(RenderListener listener, RenderQueue queue, Scene broken) {
            this.listener = listener;
            this.queue = queue;
            this.broken = broken;
        }

        private void tiles(RenderQueue.CancelSignal stop) {
            for (int tile = 0; tile < 2; tile++) {
                if (stop.isCanceled()) {
                    throw new CancellationException();
                }
            }
        }

        private void show(Scene scene, boolean isFinished) {
            renderedScene = scene;
            this.isFinished = isFinished;
            listener.rendered(
                    new Frame(null, null, DisplayMode.FULL_PICTURE, scene, scene, null, null, null, Frame.Step.ALL_LIGHT, isFinished));
        }

        @Override
        public void handle(RenderQueue.Job work, RenderQueue.CancelSignal stop) {
            if (work instanceof RenderQueue.Job.Render(Scene scene)) {
                tiles(stop);
                if (scene == broken) {
                    throw new IllegalStateException("broken");
                }
                show(scene, scene != SAMPLED && scene != SECOND_SAMPLED);
                if (!isFinished) {
                    queue.requestSamples();
                }
            } else if (work instanceof RenderQueue.Job.RenderSamples && !isFinished) {
                tiles(stop);
                show(renderedScene, true);
            }
        }

        @Override
        public Scene renderedScene() {
            return renderedScene;
        }

        @Override
        public void becomeIdle() {}

        @Override
        public void close() {
            closed = true;
        }
    }

    /** Model of everything between the two threads, with the window's state. */
    private static final class Stage {
        final RenderQueue queue = new RenderQueue(Duration.ZERO);
        final Window window = new Window();
        final List<Scene> shown = new ArrayList<>();
        final List<Throwable> problems = new ArrayList<>();
        final RenderFeed feed;
        final TileJobHandler tiles;
        final ScheduleExplorer.ConcurrentRun loop;
        boolean inWork;
        boolean settled;
        boolean cancelled;
        boolean finished;

        Stage(Scene broken) {
            RenderListener canvas = new RenderListener() {
                @Override
                public void failed(Throwable problem) {
                    window.execute(() -> problems.add(problem));
                }
            };
            feed = new RenderFeed(window, canvas, this::stateChanged);
            tiles = new TileJobHandler(feed, queue, broken);
            loop = ScheduleExplorer.startConcurrently(new RenderJobRunner(queue, tiles, feed)::run);
        }

        /** Refreshes the state as the workbench does. */
        private void stateChanged() {
            inWork = queue.isBusy();
            Frame now = feed.state().frame();
            cancelled |= feed.state().canceled();
            finished = now != null && now.isFinished();
            if (now != null && (shown.isEmpty() || shown.getLast() != now.scene())) {
                shown.add(now.scene());
            }
            settled = true;
        }

        void render(Scene scene) {
            inWork = true;
            settled = false;
            queue.render(scene);
        }

        /** Waits until the window has received the end of all its requests and all earlier events. */
        void settle() throws InterruptedException {
            while (inWork || !settled || !window.isEmpty()) {
                window.runOne();
            }
        }

        void close() throws InterruptedException {
            queue.close();
            loop.end();
            check(tiles.closed, "renderer closed with its loop");
        }
    }

    @Test
    void lastEdit_isShownLastAndEndIsReported() {
        explore(() -> {
            var stage = new Stage(null);
            stage.render(FIRST);
            if (!stage.window.isEmpty()) {
                stage.window.runOne();
            }
            stage.render(SECOND);
            while (stage.inWork) {
                stage.window.runOne();
            }
            check(stage.shown.getLast() == SECOND, "finished job delivered with its image");
            stage.settle();
            check(stage.shown.getLast() == SECOND, "last edit displayed last");
            check(stage.shown.lastIndexOf(FIRST) < stage.shown.indexOf(SECOND), "no older edit displayed after a newer one");
            stage.close();
        });
    }

    @Test
    void replacedPicture_isNeverShownAfterItsReplacement() {
        explore(() -> {
            var stage = new Stage(null);
            stage.render(LARGER);
            stage.render(FIRST);
            stage.settle();
            check(stage.shown.getLast() == FIRST, "last image displayed last");
            check(stage.shown.lastIndexOf(LARGER) <= 0, "image displayed at most once");
            stage.close();
        });
    }

    @Test
    void failedJob_isReportedAndNextIsDone() {
        explore(() -> {
            var stage = new Stage(FIRST);
            stage.render(FIRST);
            stage.settle();
            stage.render(SECOND);
            stage.settle();
            check(stage.problems.size() == 1, "failure reported once");
            check(stage.shown.equals(List.of(SECOND)), "loop continues");
            stage.close();
        });
    }

    @Test
    void antialiasedEdits_endWithSamplesOfLast() {
        explore(() -> {
            var stage = new Stage(null);
            stage.render(SAMPLED);
            if (!stage.window.isEmpty()) {
                stage.window.runOne();
            }
            stage.render(SECOND_SAMPLED);
            stage.settle();
            check(stage.shown.getLast() == SECOND_SAMPLED, "last edit displayed last");
            check(stage.shown.lastIndexOf(SAMPLED) < stage.shown.indexOf(SECOND_SAMPLED), "no older image displayed after a newer one");
            check(stage.finished, "window ends with all samples");
            check(!stage.cancelled, "preempted samples not reported as canceled");
            stage.close();
        });
    }

    @Test
    void canceled_becomesIdleWithWholePictureOrNone() {
        explore(() -> {
            var stage = new Stage(null);
            stage.render(FIRST);
            stage.queue.cancel();
            stage.inWork = stage.queue.isBusy();
            if (stage.inWork) {
                stage.settle();
            }
            stage.close();
            while (!stage.window.isEmpty()) {
                stage.window.runOne();
            }
            check(stage.shown.equals(stage.tiles.renderedScene() == null ? List.of() : List.of(FIRST)), "cache matches the display");
        });
    }

    @Test
    void closeWhileWorking_endsWithoutProblem() {
        explore(() -> {
            var stage = new Stage(null);
            stage.render(FIRST);
            stage.close();
            while (!stage.window.isEmpty()) {
                stage.window.runOne();
            }
            check(stage.problems.isEmpty(), "closing reports no failure");
        });
    }
}
