package lightning.editor.loop;

import static lightning.model.Schedules.explore;
import static lightning.model.Schedules.law;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Executor;
import lightning.editor.document.Desk;
import lightning.model.Schedules;
import lightning.scene.Antialias;
import lightning.scene.Sampling;
import lightning.scene.Scene;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** From the edit on the window's thread to the finished picture on the same thread, over the loop's. */
@Tag("model")
class RenderTurnsModelTest {
    private static final Scene FIRST = Desk.scene();
    private static final Scene SECOND = Desk.done(Desk.dial("intensity").set(FIRST, "key", 2));
    private static final Scene LARGER = FIRST.withPicture(FIRST.picture().withSize(80, 60));

    private static final Scene SAMPLED = FIRST.withPicture(FIRST.picture().withSampling(new Sampling(Antialias.EDGES, 2)));
    private static final Scene SAMPLED_TOO = SECOND.withPicture(SAMPLED.picture());

    /** The window's thread: runs what it is told, in turn, when it has time. */
    private static final class Window implements Executor {
        private final ArrayDeque<Runnable> told = new ArrayDeque<>();

        @Override
        public synchronized void execute(Runnable task) {
            told.add(task);
            notifyAll();
        }

        private synchronized Runnable next() throws InterruptedException {
            while (told.isEmpty()) {
                wait();
            }
            return told.remove();
        }

        synchronized boolean isEmpty() {
            return told.isEmpty();
        }

        void runOne() throws InterruptedException {
            next().run();
        }
    }

    /** A renderer of two tiles, and two more of finer samples where there are any. */
    private static final class Tiles implements RenderTurns.WorkHandler {
        private final RenderListener listener;
        private final RenderQueue queue;
        private final Scene broken;
        private Scene rendered;
        private boolean finished = true;
        private boolean closed;

        Tiles(RenderListener listener, RenderQueue queue, Scene broken) {
            this.listener = listener;
            this.queue = queue;
            this.broken = broken;
        }

        private void tiles(RenderQueue.Stop stop) {
            for (int tile = 0; tile < 2; tile++) {
                if (stop.isCancelled()) {
                    throw new CancellationException();
                }
            }
        }

        private void show(Scene scene, boolean whole) {
            rendered = scene;
            finished = whole;
            listener.rendered(new Frame(null, null, Look.PLAIN, scene, scene, null, null, whole));
        }

        @Override
        public void work(RenderQueue.Work work, RenderQueue.Stop stop) {
            if (work instanceof RenderQueue.Work.Render(Scene scene)) {
                tiles(stop);
                if (scene == broken) {
                    throw new IllegalStateException("broken");
                }
                show(scene, scene != SAMPLED && scene != SAMPLED_TOO);
                if (!finished) {
                    queue.finish();
                }
            } else if (work instanceof RenderQueue.Work.Finish && !finished) {
                tiles(stop);
                show(rendered, true);
            }
        }

        @Override
        public Scene rendered() {
            return rendered;
        }

        @Override
        public void rest() {}

        @Override
        public void close() {
            closed = true;
        }
    }

    /** All that stands between the two threads, and what the window knows. */
    private static final class Stage {
        final RenderQueue queue = new RenderQueue();
        final Window window = new Window();
        final List<Scene> shown = new ArrayList<>();
        final List<Throwable> problems = new ArrayList<>();
        final RenderFeed feed;
        final Tiles tiles;
        final Schedules.Beside loop;
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
            feed = new RenderFeed(window, canvas, this::hear);
            tiles = new Tiles(feed, queue, broken);
            loop = Schedules.beside(new RenderTurns(queue, tiles, feed)::run);
        }

        /** As the workbench does. */
        private void hear() {
            inWork = queue.isBusy();
            Frame now = feed.state().frame();
            cancelled |= feed.state().cancelled();
            finished = now != null && now.finished();
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

        /** Until the window knows of the end of all that it asked for, and heard all that was told until then. */
        void settle() throws InterruptedException {
            while (inWork || !settled || !window.isEmpty()) {
                window.runOne();
            }
        }

        void close() throws InterruptedException {
            queue.close();
            loop.end();
            law(tiles.closed, "the renderer is closed with its loop");
        }
    }

    @Test
    void lastEdit_isShownLastAndTheWindowHearsOfTheEnd() {
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
            law(stage.shown.getLast() == SECOND, "work that ended is taken with its picture");
            stage.settle();
            law(stage.shown.getLast() == SECOND, "the last edit is shown last");
            law(stage.shown.lastIndexOf(FIRST) < stage.shown.indexOf(SECOND), "no older edit is shown after a newer one");
            stage.close();
        });
    }

    @Test
    void pictureThatIsReplaced_isNeverShownAfterTheOneThatReplacesIt() {
        explore(() -> {
            var stage = new Stage(null);
            stage.render(LARGER);
            stage.render(FIRST);
            stage.settle();
            law(stage.shown.getLast() == FIRST, "the last picture is shown last");
            law(stage.shown.lastIndexOf(LARGER) <= 0, "a picture is shown at most once");
            stage.close();
        });
    }

    @Test
    void workThatFails_isToldAndTheNextIsDone() {
        explore(() -> {
            var stage = new Stage(FIRST);
            stage.render(FIRST);
            stage.settle();
            stage.render(SECOND);
            stage.settle();
            law(stage.problems.size() == 1, "a failure is told once");
            law(stage.shown.equals(List.of(SECOND)), "the loop lives on");
            stage.close();
        });
    }

    @Test
    void editsOfAnAntialiasedPicture_endWithTheSamplesOfTheLast() {
        explore(() -> {
            var stage = new Stage(null);
            stage.render(SAMPLED);
            if (!stage.window.isEmpty()) {
                stage.window.runOne();
            }
            stage.render(SAMPLED_TOO);
            stage.settle();
            law(stage.shown.getLast() == SAMPLED_TOO, "the last edit is shown last");
            law(stage.shown.lastIndexOf(SAMPLED) < stage.shown.indexOf(SAMPLED_TOO), "no older picture is shown after a newer one");
            law(stage.finished, "the window comes to rest with all samples");
            law(!stage.cancelled, "samples that give way to an edit are not told as cancelled");
            stage.close();
        });
    }

    @Test
    void cancelled_comesToRestAndLeavesAWholePictureOrNone() {
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
            law(stage.shown.equals(stage.tiles.rendered() == null ? List.of() : List.of(FIRST)), "what is kept is what is shown");
        });
    }

    @Test
    void closedWhileWorking_endsWithoutAProblem() {
        explore(() -> {
            var stage = new Stage(null);
            stage.render(FIRST);
            stage.close();
            while (!stage.window.isEmpty()) {
                stage.window.runOne();
            }
            law(stage.problems.isEmpty(), "closing is no failure");
        });
    }
}
