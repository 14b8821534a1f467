package lightning.document.loop;

import static lightning.modelcheck.ScheduleExplorer.check;
import static lightning.modelcheck.ScheduleExplorer.explore;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import lightning.document.DeskScene;
import lightning.modelcheck.ScheduleExplorer;
import lightning.render.RenderOptions;
import lightning.scene.Scene;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Invariants of the queue under any thread schedule. */
@Tag("model")
class RenderQueueModelTest {
    private static final Scene FIRST = DeskScene.scene();
    private static final Scene SECOND = DeskScene.sceneOf(DeskScene.parameter("intensity").set(FIRST, "key", 2));
    private static final Scene THIRD = DeskScene.sceneOf(DeskScene.parameter("intensity").set(FIRST, "key", 3));
    private static final Scene LARGER = FIRST.withPicture(FIRST.picture().withSize(80, 60));

    /** Model of a render loop that only records its jobs. */
    private static final class QueueConsumer {
        private final RenderQueue queue;
        private final List<RenderQueue.Job> finished = new ArrayList<>();
        private volatile boolean canceled;
        private boolean started;
        private boolean isIdle;
        private Scene shown;

        QueueConsumer(RenderQueue queue) {
            this.queue = queue;
        }

        void run() throws InterruptedException {
            while (true) {
                var stop = new RenderQueue.CancelSignal((_, _) -> {});
                RenderQueue.Job work = queue.take(stop);
                if (work == null) {
                    return;
                }
                boolean late = canceled;
                begin();
                check(!late || stop.isCanceled(), "canceled job not started");
                if (!stop.isCanceled()) {
                    finish(work);
                }
                setIdle(queue.finishJob(shown));
            }
        }

        private synchronized void begin() {
            started = true;
            notifyAll();
        }

        synchronized void awaitBegun() throws InterruptedException {
            while (!started) {
                wait();
            }
        }

        private synchronized void finish(RenderQueue.Job work) {
            finished.add(work);
            shown = work instanceof RenderQueue.Job.Render(Scene scene) ? scene : shown;
        }

        private synchronized void setIdle(boolean nothingLeft) {
            isIdle = nothingLeft;
            notifyAll();
        }

        synchronized List<RenderQueue.Job> finished() {
            return List.copyOf(finished);
        }

        synchronized Scene shown() {
            return shown;
        }

        synchronized void awaitRest() throws InterruptedException {
            while (!isIdle || queue.isBusy()) {
                wait();
            }
        }
    }

    @Test
    void lastRequestedEdit_isRenderedLast() {
        explore(() -> {
            var queue = new RenderQueue(Duration.ZERO);
            var taker = new QueueConsumer(queue);
            ScheduleExplorer.ConcurrentRun loop = ScheduleExplorer.startConcurrently(taker::run);
            queue.render(FIRST);
            queue.render(SECOND);
            queue.render(THIRD);
            taker.awaitRest();
            check(taker.shown() == THIRD, "last requested edit rendered last");
            int before = -1;
            for (RenderQueue.Job work : taker.finished()) {
                int number = List.of(FIRST, SECOND, THIRD).indexOf(((RenderQueue.Job.Render) work).scene());
                check(number > before, "no older edit rendered after a newer one");
                before = number;
            }
            queue.close();
            loop.end();
        });
    }

    @Test
    void jobsOfTwoThreads_areAllDone() {
        explore(() -> {
            var queue = new RenderQueue(Duration.ZERO);
            var taker = new QueueConsumer(queue);
            ScheduleExplorer.ConcurrentRun loop = ScheduleExplorer.startConcurrently(taker::run);
            ScheduleExplorer.ConcurrentRun other = ScheduleExplorer.startConcurrently(() -> {
                queue.changeOptions(RenderOptions.DEFAULT);
                queue.requestVerification();
            });
            queue.requestReflections();
            queue.requestRedisplay();
            other.end();
            taker.awaitRest();
            List<RenderQueue.Job> done = taker.finished();
            check(done.contains(new RenderQueue.Job.UpdateReflections()), "reflections not lost");
            check(done.contains(new RenderQueue.Job.Redisplay()), "redisplay not lost");
            check(done.contains(new RenderQueue.Job.Verify()), "verification not lost");
            check(done.contains(new RenderQueue.Job.ChangeOptions(RenderOptions.DEFAULT, null)), "options not lost");
            check(done.size() == 4, "no job runs twice");
            queue.close();
            loop.end();
        });
    }

    @Test
    void mirrorUpdateStoppedByEdit_runsAfterIt() {
        explore(() -> {
            var queue = new RenderQueue(Duration.ZERO);
            var taker = new QueueConsumer(queue);
            ScheduleExplorer.ConcurrentRun loop = ScheduleExplorer.startConcurrently(taker::run);
            queue.requestReflections();
            taker.awaitBegun();
            queue.render(FIRST);
            taker.awaitRest();
            check(taker.finished().contains(new RenderQueue.Job.UpdateReflections()), "reflections still requested");
            check(taker.shown() == FIRST, "edit rendered");
            queue.close();
            loop.end();
        });
    }

    @Test
    void samplesPreemptedByEdit_areRenderedAfterItWithoutCancelEvent() {
        explore(() -> {
            var queue = new RenderQueue(Duration.ZERO);
            var asked = new CountDownLatch(1);
            queue.requestSamples();
            var samples = new RenderQueue.CancelSignal((_, _) -> {});
            check(queue.take(samples) instanceof RenderQueue.Job.RenderSamples, "samples rendered without other jobs");
            ScheduleExplorer.ConcurrentRun window = ScheduleExplorer.startConcurrently(() -> {
                queue.render(FIRST);
                asked.countDown();
            });
            asked.await();
            check(samples.isCanceled() && samples.isPreempted(), "samples preempted silently");
            check(!queue.finishJob(null), "edit pending");
            check(queue.take(new RenderQueue.CancelSignal((_, _) -> {})) instanceof RenderQueue.Job.Render, "edit before samples");
            check(!queue.finishJob(FIRST), "samples still requested");
            check(queue.take(new RenderQueue.CancelSignal((_, _) -> {})) instanceof RenderQueue.Job.RenderSamples,
                    "they come after the edit");
            check(queue.finishJob(FIRST), "no job left");
            window.end();
        });
    }

    @Test
    void preemptedSamplesThenCanceled_areReportedAsCanceled() {
        explore(() -> {
            var queue = new RenderQueue(Duration.ZERO);
            queue.requestSamples();
            var samples = new RenderQueue.CancelSignal((_, _) -> {});
            queue.take(samples);
            ScheduleExplorer.ConcurrentRun window = ScheduleExplorer.startConcurrently(() -> {
                queue.render(FIRST);
                queue.cancel();
            });
            window.end();
            check(samples.isCanceled() && !samples.isPreempted(), "cancellation reported");
            check(queue.finishJob(null), "no job restarted");
        });
    }

    @Test
    void pendingSamples_runAfterEditAndBeforeVerification() {
        explore(() -> {
            var queue = new RenderQueue(Duration.ZERO);
            queue.requestVerification();
            queue.requestSamples();
            queue.render(FIRST);
            var taker = new QueueConsumer(queue);
            ScheduleExplorer.ConcurrentRun loop = ScheduleExplorer.startConcurrently(taker::run);
            taker.awaitRest();
            check(taker.finished().equals(List.of(new RenderQueue.Job.Render(FIRST), new RenderQueue.Job.RenderSamples(),
                    new RenderQueue.Job.Verify())), "what is seen first comes first");
            queue.close();
            loop.end();
        });
    }

    @Test
    void samplesCanceledWhileRunning_areNotRepeated() {
        explore(() -> {
            var queue = new RenderQueue(Duration.ZERO);
            var taker = new QueueConsumer(queue);
            ScheduleExplorer.ConcurrentRun loop = ScheduleExplorer.startConcurrently(taker::run);
            queue.requestSamples();
            taker.awaitBegun();
            queue.cancel();
            taker.awaitRest();
            check(!queue.isBusy(), "no job left");
            queue.close();
            loop.end();
        });
    }

    @Test
    void updateWhoseSceneIsShown_isReplacedByNewerSceneWithoutCancelEvent() {
        explore(() -> {
            var queue = new RenderQueue(Duration.ZERO);
            queue.render(FIRST);
            var update = new RenderQueue.CancelSignal((_, _) -> {});
            queue.take(update);
            ScheduleExplorer.ConcurrentRun window = ScheduleExplorer.startConcurrently(() -> queue.render(SECOND));
            queue.setReplaceable(update, true);
            window.end();
            check(update.isCanceled() && update.isPreempted(), "update preempted silently");
            check(!queue.finishJob(null), "newer scene pending");
            check(queue.take(new RenderQueue.CancelSignal((_, _) -> {})).equals(new RenderQueue.Job.Render(SECOND)),
                    "newer scene rendered");
        });
    }

    @Test
    void updateThatIsNotShown_isFinishedBeforeNewerScene() {
        explore(() -> {
            var queue = new RenderQueue(Duration.ZERO);
            queue.render(FIRST);
            var update = new RenderQueue.CancelSignal((_, _) -> {});
            queue.take(update);
            queue.setReplaceable(update, true);
            queue.setReplaceable(update, false);
            ScheduleExplorer.ConcurrentRun window = ScheduleExplorer.startConcurrently(() -> queue.render(SECOND));
            window.end();
            check(!update.isCanceled(), "update continues");
        });
    }

    @Test
    void newPicture_replacesTracedOne() {
        explore(() -> {
            var queue = new RenderQueue(Duration.ZERO);
            var stops = new ArrayList<RenderQueue.CancelSignal>();
            ScheduleExplorer.ConcurrentRun loop = ScheduleExplorer.startConcurrently(() -> {
                var stop = new RenderQueue.CancelSignal((_, _) -> {});
                boolean larger = queue.take(stop) instanceof RenderQueue.Job.Render(Scene scene) && scene == LARGER;
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
                check(stops.getFirst() == null || stops.getFirst().isCanceled(), "obsolete trace stopped");
            }
            loop.end();
        });
    }

    @Test
    void canceledJob_isNeitherStartedNorLeftRunning() {
        explore(() -> {
            var queue = new RenderQueue(Duration.ZERO);
            var taker = new QueueConsumer(queue);
            ScheduleExplorer.ConcurrentRun loop = ScheduleExplorer.startConcurrently(taker::run);
            queue.render(FIRST);
            queue.requestReflections();
            queue.cancel();
            taker.canceled = true;
            queue.close();
            loop.end();
        });
    }

    @Test
    void requestedJob_makesQueueBusyUntilDone() {
        explore(() -> {
            var queue = new RenderQueue(Duration.ZERO);
            var taker = new QueueConsumer(queue);
            ScheduleExplorer.ConcurrentRun loop = ScheduleExplorer.startConcurrently(taker::run);
            queue.render(FIRST);
            boolean busy = queue.isBusy();
            check(busy || taker.shown() == FIRST, "request pending, running or done");
            queue.requestVerification();
            boolean verifying = queue.isVerifying();
            check(verifying || taker.finished().contains(new RenderQueue.Job.Verify()), "verification pending, running or done");
            queue.close();
            loop.end();
        });
    }

    @Test
    void close_endsConsumer() {
        explore(() -> {
            var queue = new RenderQueue(Duration.ZERO);
            var taker = new QueueConsumer(queue);
            ScheduleExplorer.ConcurrentRun loop = ScheduleExplorer.startConcurrently(taker::run);
            ScheduleExplorer.ConcurrentRun other = ScheduleExplorer.startConcurrently(() -> queue.render(FIRST));
            queue.close();
            loop.end();
            other.end();
        });
    }
}
