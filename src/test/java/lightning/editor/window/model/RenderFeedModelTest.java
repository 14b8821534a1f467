package lightning.editor.window.model;

import static lightning.modelcheck.ScheduleExplorer.check;
import static lightning.modelcheck.ScheduleExplorer.explore;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Executor;
import lightning.document.loop.DisplayMode;
import lightning.document.loop.Frame;
import lightning.document.loop.RenderFeed;
import lightning.document.loop.RenderState;
import lightning.modelcheck.ScheduleExplorer;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Hand-over from the loop's threads to the window's thread. */
@Tag("model")
class RenderFeedModelTest {
    private static final Film FILM = Film.black(1, 1);

    /** Builds the encoding tables in advance, which takes too long within a test. */
    @BeforeAll
    static void makeTables() {
        ViewTransform.DEFAULT.toPixels(FILM);
    }

    /** Executor that stands for the window's thread and runs tasks on request. */
    private static final class Window implements Executor {
        private final ArrayDeque<Runnable> tasks = new ArrayDeque<>();
        private int executedCount;

        @Override
        public synchronized void execute(Runnable task) {
            tasks.add(task);
            executedCount++;
        }

        private synchronized Runnable next() {
            return tasks.poll();
        }

        void runAll() {
            for (Runnable task = next(); task != null; task = next()) {
                task.run();
            }
        }
    }

    @Test
    void updates_deliverNewestStateLast() {
        explore(() -> {
            var window = new Window();
            List<RenderState> heard = new ArrayList<>();
            var feeds = new RenderFeed[1];
            var feed = new RenderFeed(window, new TracedRaster(), () -> heard.add(feeds[0].state()));
            feeds[0] = feed;
            ScheduleExplorer.ConcurrentRun loop = ScheduleExplorer.startConcurrently(() -> {
                feed.progress(1, 2);
                feed.progress(2, 2);
                feed.workRemaining();
            });
            ScheduleExplorer.ConcurrentRun verifier = ScheduleExplorer.startConcurrently(() -> feed.verificationProgress(3, 3));
            window.runAll();
            loop.end();
            verifier.end();
            window.runAll();
            RenderState last = heard.getLast();
            check(last.done() == 2 && last.verifiedTiles() == 3, "the end of either work is heard");
            for (int i = 1; i < heard.size(); i++) {
                check(heard.get(i).done() >= heard.get(i - 1).done(), "nothing older is heard after something newer");
            }
            check(window.executedCount == heard.size(), "each hop is heard once");
        });
    }

    @Test
    void reportedFrame_isInRaster() {
        explore(() -> {
            var window = new Window();
            var raster = new TracedRaster();
            var feeds = new RenderFeed[1];
            var feed = new RenderFeed(window, raster,
                    () -> check(feeds[0].state().frame() == null || raster.pixels() != null, "a reported picture can be shown"));
            feeds[0] = feed;
            ScheduleExplorer.ConcurrentRun loop = ScheduleExplorer.startConcurrently(() -> {
                feed.rendered(new Frame(FILM, FILM, DisplayMode.FULL_PICTURE, null, null, null, null, null, Frame.Step.ALL_LIGHT, true));
                feed.workRemaining();
            });
            window.runAll();
            loop.end();
            window.runAll();
        });
    }

    @Test
    void pictureAndRemainingWork_areReportedTogether() {
        Frame frame = new Frame(FILM, FILM, DisplayMode.FULL_PICTURE, null, null, null, null, null, Frame.Step.ALL_LIGHT, true);
        explore(() -> {
            var window = new Window();
            var feeds = new RenderFeed[1];
            var feed = new RenderFeed(window, new TracedRaster(), () -> check(feeds[0].state().frame() == frame, "the picture is heard"));
            feeds[0] = feed;
            ScheduleExplorer.ConcurrentRun loop = ScheduleExplorer.startConcurrently(() -> {
                feed.progress(2, 2);
                feed.rendered(frame);
                feed.idle();
            });
            window.runAll();
            loop.end();
            window.runAll();
            check(window.executedCount == 1, "the window is called once");
        });
    }

    @Test
    void pictureBeforeMoreWork_isReported() {
        var window = new Window();
        var feed = new RenderFeed(window, new TracedRaster(), () -> {});
        feed.rendered(new Frame(FILM, FILM, DisplayMode.FULL_PICTURE, null, null, null, null, null, Frame.Step.ALL_LIGHT, true));
        feed.workRemaining();
        assertThat(window.executedCount).isEqualTo(1);
    }

    @Test
    void pictureOfClosedDocument_isNeitherReportedNorShown() {
        Film large = Film.black(2, 1);
        Frame old = new Frame(FILM, FILM, DisplayMode.FULL_PICTURE, null, null, null, null, null, Frame.Step.ALL_LIGHT, true);
        Frame fresh = new Frame(large, large, DisplayMode.FULL_PICTURE, null, null, null, null, null, Frame.Step.ALL_LIGHT, true);
        explore(() -> {
            var window = new Window();
            var raster = new TracedRaster();
            var feed = new RenderFeed(window, raster, () -> {});
            ScheduleExplorer.ConcurrentRun before = ScheduleExplorer.startConcurrently(() -> feed.rendered(old));
            feed.open(1);
            ScheduleExplorer.ConcurrentRun loop = ScheduleExplorer.startConcurrently(() -> {
                before.end();
                feed.pictureDropped(1);
                feed.rendered(fresh);
            });
            check(feed.state().frame() != old, "no picture of the closed document is reported");
            check(raster.pixels() == null || raster.pixels().width() == 2, "none of it is shown");
            loop.end();
            check(feed.state().frame() == fresh && raster.pixels().width() == 2, "the open document's picture is reported and shown");
        });
    }
}
