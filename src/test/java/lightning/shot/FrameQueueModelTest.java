package lightning.shot;

import static lightning.modelcheck.ScheduleExplorer.check;
import static lightning.modelcheck.ScheduleExplorer.explore;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.document.DeskScene;
import lightning.modelcheck.ScheduleExplorer;
import lightning.scene.shot.Shot;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Model-checks the path from an edit to the films of all frames, over the threads of their hosts. */
@Tag("model")
class FrameQueueModelTest {
    private static final ShotRevision FIRST = new ShotRevision(DeskScene.scene(), Shot.DEFAULT);
    private static final ShotRevision SECOND =
            new ShotRevision(DeskScene.sceneOf(DeskScene.parameter("intensity").set(FIRST.scene(), "key", 2)), Shot.DEFAULT);
    private static final int LAST = 2;

    /** Frames of one tile that record the revision that they show. */
    private static final class FakeHost extends FilmlessHost {
        private final ShotRevision[] kept = new ShotRevision[LAST + 1];
        private final boolean[] inWork = new boolean[LAST + 1];
        /** Frame whose update makes the host leave; −1 for never. */
        private final int leavesAt;
        private boolean gone;

        FakeHost(int leavesAt) {
            this.leavesAt = leavesAt;
        }

        @Override
        public FrameUpdate update(int frame, ShotRevision revision, Progress progress) throws HostLostException {
            synchronized (this) {
                gone |= frame == leavesAt;
                if (gone) {
                    throw new HostLostException("gone", null);
                }
                check(!inWork[frame], "no other lane works on the frame");
                inWork[frame] = true;
            }
            boolean stopped = progress.isCanceled();
            synchronized (this) {
                inWork[frame] = false;
                if (stopped) {
                    throw new CancellationException();
                }
                boolean traced = kept[frame] == null;
                kept[frame] = revision;
                return new FrameUpdate(frame, traced, "", 0, 0, () -> null);
            }
        }

        synchronized ShotRevision shownRevision(int frame) {
            return kept[frame];
        }
    }

    /** Queue of frames 1 and 2, the lanes of its hosts, and the events reported. */
    private static final class TestShot implements ShotListener {
        final FrameQueue queue = new FrameQueue(1, LAST);
        final List<Integer> made = Collections.synchronizedList(new ArrayList<>());
        final List<ScheduleExplorer.ConcurrentRun> lanes = new ArrayList<>();
        private final List<Throwable> problems = Collections.synchronizedList(new ArrayList<>());

        FakeHost host(int leavesAt) {
            FakeHost host = new FakeHost(leavesAt);
            int number = queue.addHost();
            for (FrameQueue.Lane lane : FrameQueue.Lane.values()) {
                lanes.add(ScheduleExplorer.startConcurrently(new FrameWorker(queue, number, lane, host, this)::run));
            }
            return host;
        }

        @Override
        public void frameUpdated(FrameUpdate update, FrameState state) {
            made.add(update.frame());
        }

        @Override
        public void frameFailed(int frame, Throwable problem) {
            problems.add(problem);
        }

        void close() throws InterruptedException {
            queue.close();
            for (ScheduleExplorer.ConcurrentRun lane : lanes) {
                lane.end();
            }
            check(problems.isEmpty(), "no frame fails");
        }
    }

    @Test
    void newestEdit_reachesAllFrames() {
        explore(() -> {
            var stage = new TestShot();
            FakeHost host = stage.host(-1);
            stage.queue.setRevision(FIRST);
            stage.queue.focus(2);
            stage.queue.setRevision(SECOND);
            stage.queue.awaitIdle();
            for (int frame = 1; frame <= LAST; frame++) {
                check(host.shownRevision(frame) == SECOND, "the newest edit is shown");
                check(stage.queue.state(frame) == FrameState.CURRENT, "its state is current");
            }
            stage.close();
        });
    }

    @Test
    void focusedFrame_isProcessedFirst() {
        explore(() -> {
            var stage = new TestShot();
            stage.queue.focus(2);
            stage.queue.setRevision(FIRST);
            stage.host(-1);
            stage.queue.awaitIdle();
            check(stage.made.equals(List.of(2, 1)), "the focused frame comes first");
            stage.close();
        });
    }

    @Test
    void removedHost_framesAreReassigned() {
        explore(() -> {
            var stage = new TestShot();
            stage.host(2);
            stage.queue.setRevision(FIRST);
            FakeHost other = stage.host(-1);
            stage.queue.setRevision(SECOND);
            stage.queue.awaitIdle();
            check(stage.queue.state(1) == FrameState.CURRENT && stage.queue.state(2) == FrameState.CURRENT, "all frames are current");
            check(other.shownRevision(2) == SECOND, "the other host traces lost frames");
            stage.close();
        });
    }

    @Test
    void close_whileWorking_endsAllLanes() {
        explore(() -> {
            var stage = new TestShot();
            stage.host(-1);
            stage.queue.setRevision(FIRST);
            stage.close();
        });
    }
}
