package lightning.shot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.InstanceOfAssertFactories.STRING;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import lightning.base.work.Await;
import lightning.base.work.Progress;
import lightning.document.DeskScene;
import lightning.scene.shot.Shot;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Tests that a frame rejected by one host goes to another. */
@Timeout(value = Await.TIMEOUT_SECONDS, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class FrameRejectionTest {
    private static final ShotRevision FIRST = new ShotRevision(DeskScene.scene(), Shot.DEFAULT);
    private static final ShotRevision SECOND =
            new ShotRevision(DeskScene.sceneOf(DeskScene.parameter("intensity").set(FIRST.scene(), "key", 2)), Shot.DEFAULT);
    private static final int LAST = 5;

    /** Host that keeps a fixed number of frames and rejects others. */
    private static final class LimitedHost extends FilmlessHost {
        final Set<Integer> held = new TreeSet<>();
        final List<Integer> refused = new ArrayList<>();
        private final int room;

        LimitedHost(int room) {
            this.room = room;
        }

        @Override
        public synchronized FrameUpdate update(int frame, ShotRevision revision, Progress progress) {
            if (!held.contains(frame) && held.size() == room) {
                refused.add(frame);
                throw new FrameRejectedException("it holds " + room);
            }
            held.add(frame);
            return new FrameUpdate(frame, true, "", 0, 0, () -> null);
        }
    }

    private final List<String> failures = Collections.synchronizedList(new ArrayList<>());

    private ShotRelighter shot(FrameHost... hosts) {
        ShotRelighter shot = ShotRelighter.of(1, LAST, new ShotListener() {
            @Override
            public void frameFailed(int frame, Throwable problem) {
                failures.add(frame + ": " + problem.getMessage());
            }
        });
        for (FrameHost host : hosts) {
            shot.addHost(host);
        }
        return shot;
    }

    private static List<FrameState> states(ShotRelighter shot) {
        List<FrameState> states = new ArrayList<>();
        for (int frame = 1; frame <= LAST; frame++) {
            states.add(shot.state(frame));
        }
        return states;
    }

    @Test
    void frameRejectedByOneHost_isRenderedByAnother() throws Exception {
        var narrow = new LimitedHost(2);
        var wide = new LimitedHost(LAST);
        try (ShotRelighter shot = shot(narrow)) {
            shot.setRevision(FIRST);
            shot.awaitIdle();
            shot.addHost(wide);
            shot.awaitIdle();
            assertThat(states(shot)).containsOnly(FrameState.CURRENT);
            assertThat(narrow.held).containsExactly(1, 2);
            assertThat(wide.held).containsExactly(3, 4, 5);
            shot.setRevision(SECOND);
            shot.awaitIdle();
            assertThat(states(shot)).containsOnly(FrameState.CURRENT);
            assertThat(narrow.refused).as("a frame held by another host is not requested").containsExactlyInAnyOrder(3, 4, 5);
        }
    }

    @Test
    void frameRejectedByAll_failsOnce_andIsRetriedAfterEdit() throws Exception {
        try (ShotRelighter shot = shot(new LimitedHost(2), new LimitedHost(2))) {
            shot.setRevision(FIRST);
            shot.awaitIdle();
            assertThat(states(shot)).containsOnly(FrameState.CURRENT, FrameState.FAILED);
            assertThat(states(shot).stream().filter(FrameState.CURRENT::equals)).hasSize(4);
            assertThat(failures).singleElement(STRING).endsWith(": no node has enough memory for it: it holds 2");
            shot.setRevision(SECOND);
            shot.awaitIdle();
            assertThat(failures).hasSize(2);
        }
    }

    @Test
    void frameWithoutRemainingHost_fails() throws Exception {
        var wide = new LimitedHost(LAST);
        try (ShotRelighter shot = shot(new LimitedHost(2), wide)) {
            shot.setRevision(FIRST);
            shot.awaitIdle();
            shot.removeHost(wide, new HostLostException("gone", null));
            shot.awaitIdle();
            assertThat(states(shot)).containsOnly(FrameState.CURRENT, FrameState.FAILED);
            assertThat(states(shot).stream().filter(FrameState.CURRENT::equals)).hasSize(2);
            assertThat(failures).hasSize(LAST - 2);
        }
    }

    @Test
    void frameOfHostLostDuringRender_isRetriedOnOthers() throws Exception {
        var queue = new FrameQueue(1, 1);
        int narrow = queue.addHost();
        int wide = queue.addHost();
        queue.setRevision(FIRST);
        FrameQueue.Job refused = queue.nextJob(narrow, FrameQueue.Lane.FOREGROUND);
        assertThat(queue.reject(refused)).isFalse();
        queue.finish(refused);
        FrameQueue.Job lost = queue.nextJob(wide, FrameQueue.Lane.FOREGROUND);
        queue.removeHost(wide);
        queue.finish(lost);
        FrameQueue.Job again = queue.nextJob(narrow, FrameQueue.Lane.FOREGROUND);
        assertThat(queue.reject(again)).isTrue();
        assertThat(queue.finish(again)).isTrue();
        assertThat(queue.state(1)).isEqualTo(FrameState.FAILED);
    }
}
