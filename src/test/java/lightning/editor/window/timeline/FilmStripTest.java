package lightning.editor.window.timeline;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import lightning.base.work.Await;
import lightning.base.work.Progress;
import lightning.document.DeskScene;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;
import lightning.shot.FilmlessHost;
import lightning.shot.FrameState;
import lightning.shot.FrameUpdate;
import lightning.shot.ShotRelighter;
import lightning.shot.ShotRevision;
import org.junit.jupiter.api.Test;

class FilmStripTest {
    private static final int FRAMES = 4;
    private static final int SILENT_FRAME = 1;

    private final CountDownLatch answer = new CountDownLatch(1);
    private final CountDownLatch requested = new CountDownLatch(1);

    private volatile CountDownLatch released = new CountDownLatch(0);

    /** Renders frames once it is released, and does not respond to requests for one frame's film. */
    private final class Keeper extends FilmlessHost {
        @Override
        public FrameUpdate update(int frame, ShotRevision take, Progress progress) {
            wait(released);
            return new FrameUpdate(frame, true, "", 0, 0, () -> Film.black(4, 3));
        }

        @Override
        public Optional<Film> film(int frame) {
            if (frame == SILENT_FRAME) {
                requested.countDown();
                wait(answer);
            }
            return Optional.of(Film.black(4, 3));
        }

        private static void wait(CountDownLatch latch) {
            try {
                latch.await();
            } catch (InterruptedException e) {
                throw new CancellationException();
            }
        }

        @Override
        public void close() {
            answer.countDown();
            released.countDown();
        }
    }

    private record TestFrames(ShotRelighter shot) implements FilmStripFrames {
        @Override
        public Scene frameScene(Scene scene) {
            return scene;
        }

        @Override
        public OptionalInt machineCount() {
            return OptionalInt.of(1);
        }

        @Override
        public void setPictureBusy(boolean v) {}

        @Override
        public void close() {
            shot.close();
        }
    }

    private FilmStrip strip() {
        var news = new FilmStripStatus();
        ShotRelighter shot = ShotRelighter.of(1, FRAMES, new Keeper(), news);
        return new FilmStrip(new TestFrames(shot), news, ViewTransform.DEFAULT, Runnable::run, () -> {}, _ -> {});
    }

    private static AnimatedScene animated(Scene scene) {
        return new AnimatedScene(scene, Optional.of(Shot.DEFAULT.withFrames(1, FRAMES)));
    }

    @Test
    void otherFrames_whileOneMachineIsSilent_haveThumbnails() throws Exception {
        try (var strip = strip()) {
            strip.setVisibleFrames(IntStream.rangeClosed(1, FRAMES).boxed().toList());
            strip.show(animated(DeskScene.scene()), 1);
            assertThat(requested.await(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS)).isTrue();
            for (int frame = 2; frame <= FRAMES; frame++) {
                waitForPicture(strip, frame);
            }
            assertThat(strip.thumbnail(SILENT_FRAME)).isEmpty();
            answer.countDown();
            waitForPicture(strip, SILENT_FRAME);
        }
    }

    @Test
    void frame_beforeItsUpdate_isStale() throws Exception {
        try (var strip = strip()) {
            strip.setVisibleFrames(List.of(2));
            strip.show(animated(DeskScene.scene()), 2);
            Await.until("the first picture", () -> strip.isUpToDate(2));
            released = new CountDownLatch(1);
            strip.show(animated(DeskScene.scene().withWorld(World.DEFAULT.withAmbience(0.5))), 2);
            assertThat(strip.state(2)).isEqualTo(FrameState.STALE);
            assertThat(strip.isUpToDate(2)).isFalse();
            assertThat(strip.thumbnail(2)).isPresent();
            released.countDown();
            Await.until("the next picture", () -> strip.isUpToDate(2));
        }
    }

    private static void waitForPicture(FilmStrip strip, int frame) throws Exception {
        Await.until("the picture of frame " + frame, () -> strip.thumbnail(frame).isPresent());
    }
}
