package lightning.shot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.InstanceOfAssertFactories.STRING;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import lightning.base.work.Progress;
import lightning.base.work.Wait;
import lightning.editor.document.Desk;
import lightning.scene.shot.Shot;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A frame for which a keeper has no room is given to another. */
@Timeout(value = Wait.MOST_SECONDS, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class FramesWithoutRoomTest {
    private static final Take FIRST = new Take(Desk.scene(), Shot.DEFAULT);
    private static final Take SECOND = new Take(Desk.done(Desk.dial("intensity").set(FIRST.scene(), "key", 2)), Shot.DEFAULT);
    private static final int LAST = 5;

    /** Holds so many frames and refuses others. */
    private static final class Narrow extends FilmlessKeeper {
        final Set<Integer> held = new TreeSet<>();
        final List<Integer> refused = new ArrayList<>();
        private final int room;

        Narrow(int room) {
            this.room = room;
        }

        @Override
        public synchronized FrameUpdate bring(int frame, Take take, Progress progress) {
            if (!held.contains(frame) && held.size() == room) {
                refused.add(frame);
                throw new FrameRefusedException("it holds " + room);
            }
            held.add(frame);
            return new FrameUpdate(frame, true, "", 0, 0, () -> null);
        }
    }

    private final List<String> failures = Collections.synchronizedList(new ArrayList<>());

    private RelitShot shot(FrameKeeper... keepers) {
        RelitShot shot = RelitShot.of(1, LAST, new ShotListener() {
            @Override
            public void failed(int frame, Throwable problem) {
                failures.add(frame + ": " + problem.getMessage());
            }
        });
        for (FrameKeeper keeper : keepers) {
            shot.join(keeper);
        }
        return shot;
    }

    private static List<FrameState> states(RelitShot shot) {
        List<FrameState> states = new ArrayList<>();
        for (int frame = 1; frame <= LAST; frame++) {
            states.add(shot.state(frame));
        }
        return states;
    }

    @Test
    void frameThatOneKeeperRefuses_isMadeByAnother() throws Exception {
        var narrow = new Narrow(2);
        var wide = new Narrow(LAST);
        try (RelitShot shot = shot(narrow)) {
            shot.edit(FIRST);
            shot.awaitIdle();
            shot.join(wide);
            shot.awaitIdle();
            assertThat(states(shot)).containsOnly(FrameState.CURRENT);
            assertThat(narrow.held).containsExactly(1, 2);
            assertThat(wide.held).containsExactly(3, 4, 5);
            shot.edit(SECOND);
            shot.awaitIdle();
            assertThat(states(shot)).containsOnly(FrameState.CURRENT);
            assertThat(narrow.refused).as("what another holds is asked of nobody else").containsExactlyInAnyOrder(3, 4, 5);
        }
    }

    @Test
    void frameThatAllRefuse_failsOnceWithASentence_andIsTriedAgainAfterAnEdit() throws Exception {
        try (RelitShot shot = shot(new Narrow(2), new Narrow(2))) {
            shot.edit(FIRST);
            shot.awaitIdle();
            assertThat(states(shot)).containsOnly(FrameState.CURRENT, FrameState.FAILED);
            assertThat(states(shot).stream().filter(FrameState.CURRENT::equals)).hasSize(4);
            assertThat(failures).singleElement(STRING).endsWith(": nobody has room for it: it holds 2");
            shot.edit(SECOND);
            shot.awaitIdle();
            assertThat(failures).hasSize(2);
        }
    }

    @Test
    void frameWhoseOnlyRoomWasLost_failsInPlaceOfWaitingForEver() throws Exception {
        var wide = new Narrow(LAST);
        try (RelitShot shot = shot(new Narrow(2), wide)) {
            shot.edit(FIRST);
            shot.awaitIdle();
            shot.leave(wide, new KeeperGoneException("gone", null));
            shot.awaitIdle();
            assertThat(states(shot)).containsOnly(FrameState.CURRENT, FrameState.FAILED);
            assertThat(states(shot).stream().filter(FrameState.CURRENT::equals)).hasSize(2);
            assertThat(failures).hasSize(LAST - 2);
        }
    }

    @Test
    void frameWhoseOnlyRoomIsLostWhileItIsMadeThere_isAskedOfTheOthersAgain() throws Exception {
        var queue = new FrameQueue(1, 1);
        int narrow = queue.join();
        int wide = queue.join();
        queue.edit(FIRST);
        FrameQueue.Work refused = queue.take(narrow, FrameQueue.Lane.FRONT);
        assertThat(queue.refuse(refused)).isFalse();
        queue.end(refused);
        FrameQueue.Work lost = queue.take(wide, FrameQueue.Lane.FRONT);
        queue.leave(wide);
        queue.end(lost);
        FrameQueue.Work again = queue.take(narrow, FrameQueue.Lane.FRONT);
        assertThat(queue.refuse(again)).isTrue();
        assertThat(queue.end(again)).isTrue();
        assertThat(queue.state(1)).isEqualTo(FrameState.FAILED);
    }
}
