package lightning.editor.window.model;

import static lightning.model.Schedules.explore;
import static lightning.model.Schedules.law;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Executor;
import lightning.editor.loop.Frame;
import lightning.editor.loop.Look;
import lightning.editor.loop.RenderFeed;
import lightning.editor.loop.RenderState;
import lightning.model.Schedules;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The hop from the loop's threads to the window's. */
@Tag("model")
class RenderFeedModelTest {
    private static final Film FILM = Film.black(1, 1);

    /** Tables of codes are made when they are needed first: too long a work for a model. */
    @BeforeAll
    static void makeTables() {
        ViewTransform.DEFAULT.toPixels(FILM);
    }

    /** The window's thread, which runs what it is told when it has time. */
    private static final class Window implements Executor {
        private final ArrayDeque<Runnable> told = new ArrayDeque<>();
        private int hops;

        @Override
        public synchronized void execute(Runnable task) {
            told.add(task);
            hops++;
        }

        private synchronized Runnable next() {
            return told.poll();
        }

        void runAll() {
            for (Runnable task = next(); task != null; task = next()) {
                task.run();
            }
        }
    }

    @Test
    void whateverIsTold_theNewestIsHeardAndNothingOlderAfterIt() {
        explore(() -> {
            var window = new Window();
            List<RenderState> heard = new ArrayList<>();
            var feeds = new RenderFeed[1];
            var feed = new RenderFeed(window, new TracedRaster(), () -> heard.add(feeds[0].state()));
            feeds[0] = feed;
            Schedules.Beside loop = Schedules.beside(() -> {
                feed.progress(1, 2);
                feed.progress(2, 2);
                feed.goesOn();
            });
            Schedules.Beside verifier = Schedules.beside(() -> feed.verifying(3, 3));
            window.runAll();
            loop.end();
            verifier.end();
            window.runAll();
            RenderState last = heard.getLast();
            law(last.done() == 2 && last.checked() == 3, "the end of either work is heard");
            for (int i = 1; i < heard.size(); i++) {
                law(heard.get(i).done() >= heard.get(i - 1).done(), "nothing older is heard after something newer");
            }
            law(window.hops == heard.size(), "each hop is heard once");
        });
    }

    @Test
    void frameThatIsHeard_isInTheRaster() {
        explore(() -> {
            var window = new Window();
            var raster = new TracedRaster();
            var feeds = new RenderFeed[1];
            var feed = new RenderFeed(window, raster,
                    () -> law(feeds[0].state().frame() == null || raster.pixels() != null, "who hears of a picture can show it"));
            feeds[0] = feed;
            Schedules.Beside loop = Schedules.beside(() -> {
                feed.rendered(new Frame(FILM, FILM, Look.PLAIN, null, null, null, null, true));
                feed.goesOn();
            });
            window.runAll();
            loop.end();
            window.runAll();
        });
    }

    @Test
    void pictureAndWhetherMoreIsToBeDone_areHeardAtOnce() {
        Frame frame = new Frame(FILM, FILM, Look.PLAIN, null, null, null, null, true);
        explore(() -> {
            var window = new Window();
            var feeds = new RenderFeed[1];
            var feed = new RenderFeed(window, new TracedRaster(), () -> law(feeds[0].state().frame() == frame, "the picture is heard"));
            feeds[0] = feed;
            Schedules.Beside loop = Schedules.beside(() -> {
                feed.progress(2, 2);
                feed.rendered(frame);
                feed.idle();
            });
            window.runAll();
            loop.end();
            window.runAll();
            law(window.hops == 1, "the window is called once");
        });
    }

    @Test
    void pictureBeforeMoreWork_isHeard() {
        var window = new Window();
        var feed = new RenderFeed(window, new TracedRaster(), () -> {});
        feed.rendered(new Frame(FILM, FILM, Look.PLAIN, null, null, null, null, true));
        feed.goesOn();
        assertThat(window.hops).isEqualTo(1);
    }

    @Test
    void pictureOfADocumentThatWasLeft_isNeitherHeardNorShown() {
        Film large = Film.black(2, 1);
        Frame old = new Frame(FILM, FILM, Look.PLAIN, null, null, null, null, true);
        Frame fresh = new Frame(large, large, Look.PLAIN, null, null, null, null, true);
        explore(() -> {
            var window = new Window();
            var raster = new TracedRaster();
            var feed = new RenderFeed(window, raster, () -> {});
            Schedules.Beside before = Schedules.beside(() -> feed.rendered(old));
            feed.open(1);
            Schedules.Beside loop = Schedules.beside(() -> {
                before.end();
                feed.forgotten(1);
                feed.rendered(fresh);
            });
            law(feed.state().frame() != old, "no picture of the document that was left is told");
            law(raster.pixels() == null || raster.pixels().width() == 2, "none of it is shown");
            loop.end();
            law(feed.state().frame() == fresh && raster.pixels().width() == 2, "that of the open one is told and shown");
        });
    }
}
