package lightning.editor.loop;

import static lightning.model.Schedules.explore;
import static lightning.model.Schedules.law;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import lightning.editor.document.Desk;
import lightning.model.Schedules;
import lightning.render.relight.tile.Options;
import lightning.scene.Scene;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The queue's laws, whatever threads do when. */
@Tag("model")
class RenderQueueModelTest {
    private static final Scene FIRST = Desk.scene();
    private static final Scene SECOND = Desk.done(Desk.dial("intensity").set(FIRST, "key", 2));
    private static final Scene THIRD = Desk.done(Desk.dial("intensity").set(FIRST, "key", 3));
    private static final Scene LARGER = FIRST.withPicture(FIRST.picture().withSize(80, 60));

    /** A render loop that does nothing with its works but remember them. */
    private static final class Taker {
        private final RenderQueue queue;
        private final List<RenderQueue.Work> finished = new ArrayList<>();
        private volatile boolean cancelled;
        private boolean begun;
        private boolean rests;
        private Scene shown;

        Taker(RenderQueue queue) {
            this.queue = queue;
        }

        void run() throws InterruptedException {
            while (true) {
                var stop = new RenderQueue.Stop((_, _) -> {});
                RenderQueue.Work work = queue.take(stop);
                if (work == null) {
                    return;
                }
                boolean late = cancelled;
                begin();
                law(!late || stop.isCancelled(), "what was cancelled is not begun");
                if (!stop.isCancelled()) {
                    finish(work);
                }
                rests(queue.done(shown));
            }
        }

        private synchronized void begin() {
            begun = true;
            notifyAll();
        }

        synchronized void awaitBegun() throws InterruptedException {
            while (!begun) {
                wait();
            }
        }

        private synchronized void finish(RenderQueue.Work work) {
            finished.add(work);
            shown = work instanceof RenderQueue.Work.Render(Scene scene) ? scene : shown;
        }

        private synchronized void rests(boolean nothingLeft) {
            rests = nothingLeft;
            notifyAll();
        }

        synchronized List<RenderQueue.Work> finished() {
            return List.copyOf(finished);
        }

        synchronized Scene shown() {
            return shown;
        }

        synchronized void awaitRest() throws InterruptedException {
            while (!rests || queue.isBusy()) {
                wait();
            }
        }
    }

    @Test
    void lastEditAsked_isRenderedAndNoneAfterIt() {
        explore(() -> {
            var queue = new RenderQueue();
            var taker = new Taker(queue);
            Schedules.Beside loop = Schedules.beside(taker::run);
            queue.render(FIRST);
            queue.render(SECOND);
            queue.render(THIRD);
            taker.awaitRest();
            law(taker.shown() == THIRD, "the last edit asked is rendered last");
            int before = -1;
            for (RenderQueue.Work work : taker.finished()) {
                int number = List.of(FIRST, SECOND, THIRD).indexOf(((RenderQueue.Work.Render) work).scene());
                law(number > before, "no older edit is rendered after a newer one");
                before = number;
            }
            queue.close();
            loop.end();
        });
    }

    @Test
    void workAskedByTwoThreads_isAllDone() {
        explore(() -> {
            var queue = new RenderQueue();
            var taker = new Taker(queue);
            Schedules.Beside loop = Schedules.beside(taker::run);
            Schedules.Beside other = Schedules.beside(() -> {
                queue.reopen(Options.DEFAULT);
                queue.verify();
            });
            queue.reflections();
            queue.look();
            other.end();
            taker.awaitRest();
            List<RenderQueue.Work> done = taker.finished();
            law(done.contains(new RenderQueue.Work.Reflections()), "mirrors are not forgotten");
            law(done.contains(new RenderQueue.Work.Looks()), "a look is not forgotten");
            law(done.contains(new RenderQueue.Work.Verify()), "a verification is not forgotten");
            law(done.contains(new RenderQueue.Work.Reopen(Options.DEFAULT, null)), "a way of working is not forgotten");
            law(done.size() == 4, "nothing is done twice");
            queue.close();
            loop.end();
        });
    }

    @Test
    void mirrorsThatAnEditStopped_areUpdatedAfterIt() {
        explore(() -> {
            var queue = new RenderQueue();
            var taker = new Taker(queue);
            Schedules.Beside loop = Schedules.beside(taker::run);
            queue.reflections();
            taker.awaitBegun();
            queue.render(FIRST);
            taker.awaitRest();
            law(taker.finished().contains(new RenderQueue.Work.Reflections()), "the mirrors are still wanted");
            law(taker.shown() == FIRST, "the edit is rendered");
            queue.close();
            loop.end();
        });
    }

    @Test
    void samplesThatAnEditStops_giveWaySilentlyAndAreMadeAfterIt() {
        explore(() -> {
            var queue = new RenderQueue();
            var asked = new CountDownLatch(1);
            queue.finish();
            var samples = new RenderQueue.Stop((_, _) -> {});
            law(queue.take(samples) instanceof RenderQueue.Work.Finish, "samples that nothing comes before are made");
            Schedules.Beside window = Schedules.beside(() -> {
                queue.render(FIRST);
                asked.countDown();
            });
            asked.await();
            law(samples.isCancelled() && samples.gaveWay(), "samples give way, and nobody hears of it");
            law(!queue.done(null), "the edit waits");
            law(queue.take(new RenderQueue.Stop((_, _) -> {})) instanceof RenderQueue.Work.Render, "the edit comes first");
            law(!queue.done(FIRST), "the samples are still wanted");
            law(queue.take(new RenderQueue.Stop((_, _) -> {})) instanceof RenderQueue.Work.Finish, "they come after the edit");
            law(queue.done(FIRST), "nothing is left");
            window.end();
        });
    }

    @Test
    void samplesThatAreCancelledAfterTheyGaveWay_areToldAsCancelled() {
        explore(() -> {
            var queue = new RenderQueue();
            queue.finish();
            var samples = new RenderQueue.Stop((_, _) -> {});
            queue.take(samples);
            Schedules.Beside window = Schedules.beside(() -> {
                queue.render(FIRST);
                queue.cancel();
            });
            window.end();
            law(samples.isCancelled() && !samples.gaveWay(), "who cancels hears of it");
            law(queue.done(null), "nothing is begun again");
        });
    }

    @Test
    void samplesThatWait_comeAfterTheEditAndBeforeTheVerification() {
        explore(() -> {
            var queue = new RenderQueue();
            queue.verify();
            queue.finish();
            queue.render(FIRST);
            var taker = new Taker(queue);
            Schedules.Beside loop = Schedules.beside(taker::run);
            taker.awaitRest();
            law(taker.finished().equals(List.of(new RenderQueue.Work.Render(FIRST), new RenderQueue.Work.Finish(),
                    new RenderQueue.Work.Verify())), "what is seen first comes first");
            queue.close();
            loop.end();
        });
    }

    @Test
    void cancelledWhileSamplesAreMade_areNotMadeAgain() {
        explore(() -> {
            var queue = new RenderQueue();
            var taker = new Taker(queue);
            Schedules.Beside loop = Schedules.beside(taker::run);
            queue.finish();
            taker.awaitBegun();
            queue.cancel();
            taker.awaitRest();
            law(!queue.isBusy(), "nothing is left to do");
            queue.close();
            loop.end();
        });
    }

    @Test
    void anotherPicture_replacesTheOneThatIsTraced() {
        explore(() -> {
            var queue = new RenderQueue();
            var stops = new ArrayList<RenderQueue.Stop>();
            Schedules.Beside loop = Schedules.beside(() -> {
                var stop = new RenderQueue.Stop((_, _) -> {});
                boolean larger = queue.take(stop) instanceof RenderQueue.Work.Render(Scene scene) && scene == LARGER;
                synchronized (stops) {
                    stops.add(larger ? stop : null);
                    stops.notifyAll();
                }
            });
            queue.render(LARGER);
            queue.render(FIRST);
            synchronized (stops) {
                while (stops.isEmpty()) {
                    stops.wait();
                }
                law(stops.getFirst() == null || stops.getFirst().isCancelled(), "a trace that is useless is stopped");
            }
            loop.end();
        });
    }

    @Test
    void cancelledWork_isNeitherBegunNorLeftRunning() {
        explore(() -> {
            var queue = new RenderQueue();
            var taker = new Taker(queue);
            Schedules.Beside loop = Schedules.beside(taker::run);
            queue.render(FIRST);
            queue.reflections();
            queue.cancel();
            taker.cancelled = true;
            queue.close();
            loop.end();
        });
    }

    @Test
    void workThatIsAsked_makesItBusyUntilItIsDone() {
        explore(() -> {
            var queue = new RenderQueue();
            var taker = new Taker(queue);
            Schedules.Beside loop = Schedules.beside(taker::run);
            queue.render(FIRST);
            boolean busy = queue.isBusy();
            law(busy || taker.shown() == FIRST, "what is asked is waiting, running or done");
            queue.verify();
            boolean verifying = queue.isVerifying();
            law(verifying || taker.finished().contains(new RenderQueue.Work.Verify()), "a verification waits, runs or is done");
            queue.close();
            loop.end();
        });
    }

    @Test
    void closed_endsWhoTakes() {
        explore(() -> {
            var queue = new RenderQueue();
            var taker = new Taker(queue);
            Schedules.Beside loop = Schedules.beside(taker::run);
            Schedules.Beside other = Schedules.beside(() -> queue.render(FIRST));
            queue.close();
            loop.end();
            other.end();
        });
    }
}
