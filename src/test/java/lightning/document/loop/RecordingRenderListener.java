package lightning.document.loop;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import lightning.base.work.Await;
import lightning.render.image.Film;
import lightning.render.measure.Verification;
import lightning.render.measure.WarmSaving;
import lightning.render.relight.plan.UpdatePlan;
import lightning.scene.Scene;

/** Recording listener of a render loop that can hold it at its next tile. */
public final class RecordingRenderListener implements RenderListener {
    final LinkedBlockingQueue<Object> events = new LinkedBlockingQueue<>();
    private final AtomicReference<Hold> nextTileHold = new AtomicReference<>();
    private final AtomicReference<Hold> nextPictureHold = new AtomicReference<>();

    /** Reported image with a copy of its film. */
    record Shown(Frame frame, Film film) {}

    /** Last reported content of each tile. */
    final Map<Integer, float[][]> tiles = new ConcurrentHashMap<>();

    record Coarse(Film film) {}

    record Started(UpdatePlan plan) {}

    public enum Event {
        CANCELLED, IDLE
    }

    /** Point at which the loop is held. */
    public static final class Hold {
        private final CountDownLatch reached = new CountDownLatch(1);
        private final CountDownLatch released = new CountDownLatch(1);

        public void awaitReached() throws InterruptedException {
            if (!reached.await(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS)) {
                throw new AssertionError("the loop did not come to a tile");
            }
        }

        public void release() {
            released.countDown();
        }

        private void block() {
            reached.countDown();
            try {
                released.await(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }
    }

    /** Holds the next tile of an update until released. */
    public Hold holdNextTile() {
        var next = new Hold();
        nextTileHold.set(next);
        return next;
    }

    /** Holds the next tile after the next image until released. */
    public Hold holdAfterNextPicture() {
        var next = new Hold();
        nextPictureHold.set(next);
        return next;
    }

    /** Waits for the next event of this kind; drops others before it. */
    public <T> T next(Class<T> kind) throws InterruptedException {
        while (true) {
            Object event = events.poll(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS);
            if (event == null) {
                throw new AssertionError("no " + kind.getSimpleName() + " came");
            }
            if (event instanceof Throwable problem && !kind.isInstance(event)) {
                throw new AssertionError("the loop failed", problem);
            }
            if (kind.isInstance(event)) {
                return kind.cast(event);
            }
        }
    }

    public void expectNext(Event expected) throws InterruptedException {
        Event event = next(Event.class);
        while (event != expected) {
            event = next(Event.class);
        }
    }

    @Override
    public void started(UpdatePlan plan) {
        events.add(new Started(plan));
    }

    @Override
    public void progress(int done, int total) {
        Hold now = nextTileHold.getAndSet(null);
        if (now != null) {
            now.block();
        }
    }

    @Override
    public void tileRendered(Scene scene, int tile, float[][] film) {
        tiles.put(tile, film);
    }

    @Override
    public void coarseRendered(Film film, Scene scene) {
        events.add(new Coarse(film.copy()));
    }

    @Override
    public void rendered(Frame frame) {
        Hold next = nextPictureHold.getAndSet(null);
        if (next != null) {
            nextTileHold.set(next);
        }
        events.add(new Shown(frame, frame.film().copy()));
    }

    @Override
    public void savingMeasured(WarmSaving saving) {
        events.add(saving);
    }

    @Override
    public void verified(Verification verification) {
        events.add(verification);
    }

    @Override
    public void canceled() {
        events.add(Event.CANCELLED);
    }

    @Override
    public void failed(Throwable problem) {
        events.add(problem);
    }

    @Override
    public void idle() {
        events.add(Event.IDLE);
    }
}
