package lightning.editor.window.timeline;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import lightning.base.work.Progress;
import lightning.base.work.Wait;
import lightning.editor.document.Desk;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;
import lightning.shot.FilmlessKeeper;
import lightning.shot.FrameState;
import lightning.shot.FrameUpdate;
import lightning.shot.RelitShot;
import lightning.shot.Take;
import org.junit.jupiter.api.Test;

class FilmStripTest {
    private static final int FRAMES = 4;
    private static final int SILENT = 1;

    private final CountDownLatch answer = new CountDownLatch(1);
    private final CountDownLatch asked = new CountDownLatch(1);

    private volatile CountDownLatch free = new CountDownLatch(0);

    /** Makes frames once it is free, and does not say what one of them looks like. */
    private final class Keeper extends FilmlessKeeper {
        @Override
        public FrameUpdate bring(int frame, Take take, Progress progress) {
            wait(free);
            return new FrameUpdate(frame, true, "", 0, 0, () -> Film.black(4, 3));
        }

        @Override
        public Optional<Film> film(int frame) {
            if (frame == SILENT) {
                asked.countDown();
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
            free.countDown();
        }
    }

    private record Frames(RelitShot shot) implements StripFrames {
        @Override
        public Scene kept(Scene scene) {
            return scene;
        }

        @Override
        public OptionalInt machines() {
            return OptionalInt.of(1);
        }

        @Override
        public void setUrgent(boolean v) {}

        @Override
        public void close() {
            shot.close();
        }
    }

    private FilmStrip strip() {
        var news = new StripNews();
        RelitShot shot = RelitShot.of(1, FRAMES, new Keeper(), news);
        return new FilmStrip(new Frames(shot), news, ViewTransform.DEFAULT, Runnable::run, () -> {}, _ -> {});
    }

    private static AnimatedScene animated(Scene scene) {
        return new AnimatedScene(scene, Optional.of(Shot.DEFAULT.withFrames(1, FRAMES)));
    }

    @Test
    void framesBesideOneWhoseMachineIsSilent_haveTheirPictures() throws Exception {
        try (var strip = strip()) {
            strip.see(IntStream.rangeClosed(1, FRAMES).boxed().toList());
            strip.show(animated(Desk.scene()), 1);
            assertThat(asked.await(Wait.MOST_SECONDS, TimeUnit.SECONDS)).isTrue();
            for (int frame = 2; frame <= FRAMES; frame++) {
                waitForPicture(strip, frame);
            }
            assertThat(strip.picture(SILENT)).isEmpty();
            answer.countDown();
            waitForPicture(strip, SILENT);
        }
    }

    @Test
    void frameThatAnEditReachesLater_isStaleUntilThen() throws Exception {
        try (var strip = strip()) {
            strip.see(List.of(2));
            strip.show(animated(Desk.scene()), 2);
            Wait.until("the first picture", () -> strip.showsNewest(2));
            free = new CountDownLatch(1);
            strip.show(animated(Desk.scene().withWorld(World.DEFAULT.withAmbience(0.5))), 2);
            assertThat(strip.state(2)).isEqualTo(FrameState.STALE);
            assertThat(strip.showsNewest(2)).isFalse();
            assertThat(strip.picture(2)).isPresent();
            free.countDown();
            Wait.until("the next picture", () -> strip.showsNewest(2));
        }
    }

    private static void waitForPicture(FilmStrip strip, int frame) throws Exception {
        Wait.until("the picture of frame " + frame, () -> strip.picture(frame).isPresent());
    }
}
