package lightning.shot;

import static lightning.model.Schedules.explore;
import static lightning.model.Schedules.law;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.editor.document.Desk;
import lightning.model.Schedules;
import lightning.scene.shot.Shot;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** From an edit to the films of all frames, over the threads of their keepers. */
@Tag("model")
class FrameQueueModelTest {
    private static final Take FIRST = new Take(Desk.scene(), Shot.DEFAULT);
    private static final Take SECOND = new Take(Desk.done(Desk.dial("intensity").set(FIRST.scene(), "key", 2)), Shot.DEFAULT);
    private static final int LAST = 2;

    /** Frames of one tile, each known by the take that it shows. */
    private static final class Tiles extends FilmlessKeeper {
        private final Take[] kept = new Take[LAST + 1];
        private final boolean[] inWork = new boolean[LAST + 1];
        /** The frame that it is asked for when it goes away; −1 for never. */
        private final int leavesAt;
        private boolean gone;

        Tiles(int leavesAt) {
            this.leavesAt = leavesAt;
        }

        @Override
        public FrameUpdate bring(int frame, Take take, Progress progress) throws KeeperGoneException {
            synchronized (this) {
                gone |= frame == leavesAt;
                if (gone) {
                    throw new KeeperGoneException("gone", null);
                }
                law(!inWork[frame], "nobody else is at the frame");
                inWork[frame] = true;
            }
            boolean stopped = progress.isCancelled();
            synchronized (this) {
                inWork[frame] = false;
                if (stopped) {
                    throw new CancellationException();
                }
                boolean traced = kept[frame] == null;
                kept[frame] = take;
                return new FrameUpdate(frame, traced, "", 0, 0, () -> null);
            }
        }

        synchronized Take kept(int frame) {
            return kept[frame];
        }
    }

    /** A queue of frames 1 and 2, the lanes of its keepers, and what was told. */
    private static final class Stage implements ShotListener {
        final FrameQueue queue = new FrameQueue(1, LAST);
        final List<Integer> made = Collections.synchronizedList(new ArrayList<>());
        final List<Schedules.Beside> lanes = new ArrayList<>();
        private final List<Throwable> problems = Collections.synchronizedList(new ArrayList<>());

        Tiles keeper(int leavesAt) {
            Tiles keeper = new Tiles(leavesAt);
            int number = queue.join();
            for (FrameQueue.Lane lane : FrameQueue.Lane.values()) {
                lanes.add(Schedules.beside(new KeeperTurns(queue, number, lane, keeper, this)::run));
            }
            return keeper;
        }

        @Override
        public void updated(FrameUpdate update, FrameState state) {
            made.add(update.frame());
        }

        @Override
        public void failed(int frame, Throwable problem) {
            problems.add(problem);
        }

        void close() throws InterruptedException {
            queue.close();
            for (Schedules.Beside lane : lanes) {
                lane.end();
            }
            law(problems.isEmpty(), "no frame fails");
        }
    }

    @Test
    void newestEdit_isShownByAllFramesInTheEnd() {
        explore(() -> {
            var stage = new Stage();
            Tiles keeper = stage.keeper(-1);
            stage.queue.edit(FIRST);
            stage.queue.focus(2);
            stage.queue.edit(SECOND);
            stage.queue.awaitIdle();
            for (int frame = 1; frame <= LAST; frame++) {
                law(keeper.kept(frame) == SECOND, "the newest edit is shown");
                law(stage.queue.state(frame) == FrameState.CURRENT, "it is known to be");
            }
            stage.close();
        });
    }

    @Test
    void frameInFocus_isMadeBeforeTheOthers() {
        explore(() -> {
            var stage = new Stage();
            stage.queue.focus(2);
            stage.queue.edit(FIRST);
            stage.keeper(-1);
            stage.queue.awaitIdle();
            law(stage.made.equals(List.of(2, 1)), "the one that is looked at comes first");
            stage.close();
        });
    }

    @Test
    void keeperThatGoesAway_leavesNoFrameBehind() {
        explore(() -> {
            var stage = new Stage();
            stage.keeper(2);
            stage.queue.edit(FIRST);
            Tiles other = stage.keeper(-1);
            stage.queue.edit(SECOND);
            stage.queue.awaitIdle();
            law(stage.queue.state(1) == FrameState.CURRENT && stage.queue.state(2) == FrameState.CURRENT, "all frames are current");
            law(other.kept(2) == SECOND, "the other traces what was lost");
            stage.close();
        });
    }

    @Test
    void closedWhileWorking_endsAllLanes() {
        explore(() -> {
            var stage = new Stage();
            stage.keeper(-1);
            stage.queue.edit(FIRST);
            stage.close();
        });
    }
}
